import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { setMaterialColor } from '../../kit/three/material-color.ts';
import { createMeshItem } from '../../kit/three/mesh-item.ts';
import type { Candidate } from './candidates.ts';

/** The band along the outline of a surface, as an object. */
export interface Outline {
  /**
   * Updates the object.
   *
   * @param worldFromOutline Column-major 4×4, rigid.
   * @param worldFromCenter Its y axis points to the side that is seen.
   */
  update(
    found: Candidate | null,
    worldFromOutline: Float32Array,
    worldFromCenter: Float32Array,
    bandM: number,
    color: ArrayLike<number>,
  ): void;
  dispose(): void;
}

/** Distance of the band from the surface, so that the surface's depth and phantoms do not hide it. */
const LIFT_M = 0.005;
/** Limit of the miter at sharp corners, as a multiple of the band's width. */
const MITER = 4;

export function createOutline(list: ObjectList): Outline {
  const material = new MeshBasicMaterial({ side: DoubleSide });
  const mesh = new Mesh(new BufferGeometry(), material);
  const item = createMeshItem('outline', mesh);
  let shown: Candidate | null = null;
  let shownBandM = 0;

  function build({ outlineXZ }: Candidate, bandM: number): void {
    mesh.geometry.dispose();
    mesh.geometry = bandOf(outlineXZ, bandM);
    shownBandM = bandM;
    // Readers keep the geometry until the version changes.
    list.version++;
  }

  return {
    update: (found, worldFromOutline, worldFromCenter, bandM, color) => {
      if (found && (found !== shown || bandM !== shownBandM)) build(found, bandM);
      if (list.items.length > 0 !== (found !== null)) {
        list.items.length = 0;
        if (found) list.items.push(item);
        list.version++;
      }
      shown = found;
      if (!found) return;
      item.worldFromObject.fromArray(worldFromOutline);
      const { elements } = item.worldFromObject;
      for (let row = 0; row < 3; row++) elements[12 + row] = (elements[12 + row] ?? 0) + LIFT_M * (worldFromCenter[4 + row] ?? 0);
      setMaterialColor(material, color);
    },
    dispose: () => {
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}

/**
 * Builds the band: two triangles per side of the polygon, between the polygon and the same polygon moved inwards by the width of the band.
 */
function bandOf(xz: Float32Array, bandM: number): BufferGeometry {
  const count = xz.length / 2;
  const positions = new Float32Array(6 * count);
  const index: number[] = [];
  let twice = 0;
  for (let i = 0; i < count; i++) {
    const j = (i + 1) % count;
    twice += (xz[2 * i] ?? 0) * (xz[2 * j + 1] ?? 0) - (xz[2 * j] ?? 0) * (xz[2 * i + 1] ?? 0);
  }
  const inwards = twice < 0 ? -1 : 1;
  for (let i = 0; i < count; i++) {
    const [before, after] = [(i + count - 1) % count, (i + 1) % count];
    const x = xz[2 * i] ?? 0;
    const z = xz[2 * i + 1] ?? 0;
    // Normals of both sides at the corner, to the inside.
    const a = normalOf(xz, before, i, inwards);
    const b = normalOf(xz, i, after, inwards);
    const sum = Math.hypot(a[0] + b[0], a[1] + b[1]);
    const length = sum > 1e-6 ? Math.min((2 * bandM) / sum, MITER * bandM) : 0;
    positions.set([x, 0, z, x + ((a[0] + b[0]) / (sum || 1)) * length, 0, z + ((a[1] + b[1]) / (sum || 1)) * length], 6 * i);
    index.push(2 * i, 2 * i + 1, 2 * after, 2 * after, 2 * i + 1, 2 * after + 1);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(index);
  return geometry;
}

function normalOf(xz: Float32Array, from: number, to: number, inwards: number): readonly [number, number] {
  const x = (xz[2 * to] ?? 0) - (xz[2 * from] ?? 0);
  const z = (xz[2 * to + 1] ?? 0) - (xz[2 * from + 1] ?? 0);
  const length = Math.hypot(x, z) || 1;
  return [(-z / length) * inwards, (x / length) * inwards];
}
