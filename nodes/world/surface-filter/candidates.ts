import type { DetectedMesh, DetectedPlane, DetectedSurface, DetectedSurfaces } from '../../kit/session.ts';
import { areaOf, convexHull, sideAngleRad, writeCentroid } from './polygon.ts';

/** A detected surface as a flat outline, which the filter rates. */
export interface Candidate {
  readonly surface: DetectedSurface;
  readonly version: number;
  /** Corners of the outline, alternating x and z, in the candidate's own space, whose y axis is the normal or its opposite. */
  readonly outlineXZ: Float32Array;
  /** The matrix from the candidate's own space to that of the surface, column-major 4×4, rigid; null: the identity. */
  readonly surfaceFromOutline: Float32Array | null;
  readonly areaSquareM: number;
  /** x and z of the outline's centroid. */
  readonly centerXZ: Float64Array;
  /** The direction of the outline's sides: an angle from x towards z. */
  readonly sideRad: number;
  /** The number of the last update in which the surface was detected. */
  seen: number;
}

/** The detected surfaces as candidates. A candidate is computed again when its surface changes. */
export interface Candidates {
  readonly all: readonly Candidate[];
  /** Adds, updates and removes candidates as surfaces are detected. Call it once per frame. */
  update(surfaces: DetectedSurfaces | null | undefined): void;
  clear(): void;
}

/** A mesh whose footprint is larger than a square with this side, or which has the label `ROOM_LABEL`, is that of a whole room. */
const ROOM_SIDE_M = 4;
const ROOM_LABEL = 'global mesh';

export function createCandidates(kind: 'planes' | 'meshes' | 'both'): Candidates {
  const all: Candidate[] = [];
  let round = 0;

  function see(surface: DetectedPlane | DetectedMesh): void {
    for (let i = 0; i < all.length; i++) {
      const known = all[i];
      if (known?.surface !== surface) continue;
      const current = known.version === surface.version ? known : make(surface);
      current.seen = round;
      all[i] = current;
      return;
    }
    const made = make(surface);
    made.seen = round;
    all.push(made);
  }

  return {
    all,
    update: (surfaces) => {
      round++;
      const planes = kind === 'meshes' ? undefined : surfaces?.planes;
      const meshes = kind === 'planes' ? undefined : surfaces?.meshes;
      for (let i = 0; planes && i < planes.length; i++) {
        const plane = planes[i];
        if (plane) see(plane);
      }
      for (let i = 0; meshes && i < meshes.length; i++) {
        const mesh = meshes[i];
        if (mesh) see(mesh);
      }
      for (let i = all.length - 1; i >= 0; i--) if (all[i]?.seen !== round) all.splice(i, 1);
    },
    clear: () => {
      all.length = 0;
    },
  };
}

function make(surface: DetectedPlane | DetectedMesh): Candidate {
  return 'positions' in surface ? topOf(surface) : candidateOf(surface, surface.outlineXZ, null);
}

function candidateOf(surface: DetectedSurface, outlineXZ: Float32Array, surfaceFromOutline: Float32Array | null): Candidate {
  const centerXZ = new Float64Array(2);
  writeCentroid(centerXZ, outlineXZ);
  const { version } = surface;
  return {
    surface,
    version,
    outlineXZ,
    surfaceFromOutline,
    areaSquareM: areaOf(outlineXZ),
    centerXZ,
    sideRad: sideAngleRad(outlineXZ),
    seen: 0,
  };
}

/**
 * The candidate of a mesh: its convex hull as seen from above, at the height of its highest point. The mesh of a whole room has no such
 * top, so its outline is empty.
 */
function topOf(mesh: DetectedMesh): Candidate {
  const { worldFromSurface: m, positions } = mesh;
  const footprint = new Float32Array((positions.length / 3) * 2);
  let topM = Number.NEGATIVE_INFINITY;
  for (let i = 0; i + 2 < positions.length; i += 3) {
    const x = positions[i] ?? 0;
    const y = positions[i + 1] ?? 0;
    const z = positions[i + 2] ?? 0;
    // Turned as the world is, but still around the origin of the mesh.
    footprint[(i / 3) * 2] = (m[0] ?? 0) * x + (m[4] ?? 0) * y + (m[8] ?? 0) * z;
    footprint[(i / 3) * 2 + 1] = (m[2] ?? 0) * x + (m[6] ?? 0) * y + (m[10] ?? 0) * z;
    topM = Math.max(topM, (m[1] ?? 0) * x + (m[5] ?? 0) * y + (m[9] ?? 0) * z);
  }
  const hull = convexHull(footprint);
  const isRoom = mesh.label === ROOM_LABEL || hull.length < 6 || areaOf(hull) > ROOM_SIDE_M * ROOM_SIDE_M;
  // The inverse of the rotation turns it back.
  const surfaceFromOutline = new Float32Array(16);
  for (let row = 0; row < 3; row++)
    for (let column = 0; column < 3; column++) surfaceFromOutline[4 * column + row] = m[4 * row + column] ?? 0;
  for (let row = 0; row < 3; row++) surfaceFromOutline[12 + row] = (m[4 * row + 1] ?? 0) * topM;
  surfaceFromOutline[15] = 1;
  return candidateOf(mesh, isRoom ? new Float32Array(0) : hull, surfaceFromOutline);
}
