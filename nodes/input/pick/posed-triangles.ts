import { Matrix4, type Mesh, type SkinnedMesh } from 'three';
import type { Ray } from '../../kit/hit-test.ts';
import type { GeometryTriangles } from './geometry-triangles.ts';
import { castAtTriangle, entryOf, type Sides, type TriangleHit } from './triangle-tree.ts';

/** The triangles of a skinned or morphed mesh in its current pose. */
export interface PosedTriangles {
  /** Casts a ray as `castAtTree` does, in the space of the mesh. The world matrices of the mesh and of its bones must be current. */
  cast(out: TriangleHit, ray: Ray, sides: Sides): boolean;
}

/** Number of triangles per cluster. The triangles of a cluster are neighbors at rest, so that few bones move them. */
const CLUSTER = 64;
/** Tolerance for the sum of quantized skin weights, which is not exactly 1. */
const ROUNDING = 0.01;

const EMPTY_BOX = [...Array<number>(3).fill(Number.POSITIVE_INFINITY), ...Array<number>(3).fill(Number.NEGATIVE_INFINITY)];

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchBounds = new Float64Array(6);
const scratchCorners = new Float64Array(9);

/**
 * Prepares casting rays at a skinned or morphed mesh. Triangles are grouped in clusters with bounding boxes per bone, so that only the
 * triangles of clusters that the ray may meet are posed. This is correct because a skinned vertex stays within the convex hull of the
 * places to which each of its bones alone would move it, so a cluster stays within the boxes that its bones move. Nothing is computed while
 * no ray is cast.
 */
export function createPosedTriangles(mesh: Mesh, { vertices, tree: { order } }: GeometryTriangles): PosedTriangles {
  const skinned = 'isSkinnedMesh' in mesh ? (mesh as SkinnedMesh) : null;
  const { position, skinIndex, skinWeight } = mesh.geometry.attributes;
  const morphs = mesh.geometry.morphAttributes.position ?? [];
  const isRelative = mesh.geometry.morphTargetsRelative;
  const bones = skinned?.skeleton.bones.length ?? 1;
  /** For each bone, the 4×4 matrix from the mesh at rest to the posed mesh. */
  const palette = new Float64Array(16 * bones);
  const reach = morphs.map((_, i) => reachOf(i));
  const rest = new Float64Array(3);
  const clusters: Cluster[] = [];
  for (let from = 0; from < order.length; from += CLUSTER) clusters.push(clusterOf(from, Math.min(from + CLUSTER, order.length)));

  /** The greatest distance by which a morph target moves a vertex along an axis. */
  function reachOf(target: number): number {
    let farthest = 0;
    for (let vertex = 0; vertex < (position?.count ?? 0); vertex++) {
      for (let axis = 0; axis < 3; axis++) farthest = Math.max(farthest, Math.abs(shiftOf(target, vertex, axis)));
    }
    return farthest;
  }
  function shiftOf(target: number, vertex: number, axis: number): number {
    const shifted = morphs[target]?.getComponent(vertex, axis) ?? 0;
    return isRelative ? shifted : shifted - (position?.getComponent(vertex, axis) ?? 0);
  }

  /**
   * Writes the position of a vertex after morphing and before skinning, in the space of the mesh. Morph targets are added as in three.js.
   */
  function writeRest(vertex: number, isMorphed: boolean): void {
    for (let axis = 0; axis < 3; axis++) {
      let value = position?.getComponent(vertex, axis) ?? 0;
      for (let m = 0; isMorphed && m < morphs.length; m++) {
        const influence = mesh.morphTargetInfluences?.[m] ?? 0;
        if (influence !== 0) value += influence * shiftOf(m, vertex, axis);
      }
      rest[axis] = value;
    }
  }

  function clusterOf(from: number, to: number): Cluster {
    const boxes = new Map<number, number[]>();
    for (let t = from; t < to; t++) {
      for (let corner = 0; corner < 3; corner++) {
        const vertex = vertices[3 * (order[t] ?? 0) + corner] ?? 0;
        writeRest(vertex, false);
        for (let k = 0; k < (skinned ? 4 : 1); k++) {
          if (skinned && !((skinWeight?.getComponent(vertex, k) ?? 0) > 0)) continue;
          const bone = skinned ? (skinIndex?.getComponent(vertex, k) ?? 0) : 0;
          const box = boxes.get(bone) ?? [...EMPTY_BOX];
          boxes.set(bone, box);
          for (let axis = 0; axis < 3; axis++) {
            box[axis] = Math.min(box[axis] ?? 0, rest[axis] ?? 0);
            box[3 + axis] = Math.max(box[3 + axis] ?? 0, rest[axis] ?? 0);
          }
        }
      }
    }
    return { from, to, bones: Uint16Array.from(boxes.keys()), boxes: Float32Array.from([...boxes.values()].flat()) };
  }

  function writePalette(): void {
    if (!skinned) {
      scratchMatrix.identity();
      palette.set(scratchMatrix.elements);
      return;
    }
    const { skeleton, bindMatrix, bindMatrixInverse } = skinned;
    for (let b = 0; b < bones; b++) {
      const bone = skeleton.bones[b];
      const inverse = skeleton.boneInverses[b];
      if (!bone || !inverse) continue;
      scratchMatrix.multiplyMatrices(bindMatrixInverse, bone.matrixWorld).multiply(inverse).multiply(bindMatrix);
      palette.set(scratchMatrix.elements, 16 * b);
    }
  }

  function writeClusterBounds({ bones: moved, boxes }: Cluster, wideningM: number): void {
    scratchBounds.fill(Number.POSITIVE_INFINITY, 0, 3);
    scratchBounds.fill(Number.NEGATIVE_INFINITY, 3, 6);
    for (let b = 0; b < moved.length; b++) {
      const m = 16 * (moved[b] ?? 0);
      for (let axis = 0; axis < 3; axis++) {
        let center = palette[m + 12 + axis] ?? 0;
        let half = 0;
        for (let from = 0; from < 3; from++) {
          const least = boxes[6 * b + from] ?? 0;
          const greatest = boxes[6 * b + 3 + from] ?? 0;
          const factor = palette[m + 4 * from + axis] ?? 0;
          center += (factor * (least + greatest)) / 2;
          half += Math.abs(factor) * ((greatest - least) / 2 + wideningM);
        }
        scratchBounds[axis] = Math.min(scratchBounds[axis] ?? 0, center - half);
        scratchBounds[3 + axis] = Math.max(scratchBounds[3 + axis] ?? 0, center + half);
      }
    }
    if (!skinned) return;
    for (let axis = 0; axis < 3; axis++) {
      const slack = ((scratchBounds[3 + axis] ?? 0) - (scratchBounds[axis] ?? 0)) * ROUNDING;
      scratchBounds[axis] = (scratchBounds[axis] ?? 0) - slack;
      scratchBounds[3 + axis] = (scratchBounds[3 + axis] ?? 0) + slack;
    }
  }

  function writePosed(vertex: number, at: number): void {
    writeRest(vertex, true);
    scratchCorners.fill(0, at, at + 3);
    for (let k = 0; k < (skinned ? 4 : 1); k++) {
      const weight = skinned ? (skinWeight?.getComponent(vertex, k) ?? 0) : 1;
      if (weight === 0) continue;
      const m = 16 * (skinned ? (skinIndex?.getComponent(vertex, k) ?? 0) : 0);
      for (let axis = 0; axis < 3; axis++) {
        const moved =
          (palette[m + axis] ?? 0) * (rest[0] ?? 0) +
          (palette[m + 4 + axis] ?? 0) * (rest[1] ?? 0) +
          (palette[m + 8 + axis] ?? 0) * (rest[2] ?? 0) +
          (palette[m + 12 + axis] ?? 0);
        scratchCorners[at + axis] = (scratchCorners[at + axis] ?? 0) + weight * moved;
      }
    }
  }

  return {
    cast: (out, ray, sides) => {
      writePalette();
      let wideningM = 0;
      for (let m = 0; m < morphs.length; m++) wideningM += Math.abs(mesh.morphTargetInfluences?.[m] ?? 0) * (reach[m] ?? 0);
      let found = false;
      for (let i = 0; i < clusters.length; i++) {
        const cluster = clusters[i];
        if (!cluster) continue;
        writeClusterBounds(cluster, wideningM);
        if (!(entryOf(scratchBounds, 0, ray, out.along) < Number.POSITIVE_INFINITY)) continue;
        for (let t = cluster.from; t < cluster.to; t++) {
          for (let corner = 0; corner < 3; corner++) writePosed(vertices[3 * (order[t] ?? 0) + corner] ?? 0, 3 * corner);
          found = castAtTriangle(out, scratchCorners, 0, ray, sides) || found;
        }
      }
      return found;
    },
  };
}

interface Cluster {
  /** The cluster has the triangles `from` up to, but not including, `to`, in the order of the tree. */
  readonly from: number;
  readonly to: number;
  /**
   * The bones that move the cluster's vertices. `boxes` has for each bone the box around the vertices that it moves, at rest: least x, y,
   * z, greatest x, y, z.
   */
  readonly bones: Uint16Array;
  readonly boxes: Float32Array;
}
