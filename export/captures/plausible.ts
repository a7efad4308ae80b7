import type { CaptureMesh } from '../../nodes/kit/capture.ts';
import { type Lens, project } from './lens.ts';

/** Diagonals of meshes of objects, rooms and streets, meters. */
const LEAST_DIAGONAL_M = 0.02;
const MOST_DIAGONAL_M = 500;

/**
 * A warning about a mesh that has hardly been measured in meters, or null.
 *
 * @param sizeM Size of the mesh along x, y and z.
 */
export function unitWarning(sizeM: readonly number[]): string | null {
  const diagonalM = Math.hypot(...sizeM);
  if (diagonalM >= LEAST_DIAGONAL_M && diagonalM <= MOST_DIAGONAL_M) return null;
  const length = diagonalM < LEAST_DIAGONAL_M ? `${(diagonalM * 1000).toPrecision(2)} mm` : `${Math.round(diagonalM)} m`;
  return `The mesh has a diagonal of ${length}. If its unit is not the meter, import it again with --unit.`;
}

/** Number of vertices that are tested. */
const SAMPLES = 20_000;

/**
 * Whether a camera has at least one vertex of the mesh in its picture. Both are in the space of the reconstruction.
 *
 * @param worldFromCamera Column-major 4×4; the camera looks along −z.
 */
export function seesMesh({ positions }: CaptureMesh, lens: Lens, worldFromCamera: readonly number[]): boolean {
  if (lens.projection === 'equirectangular') return true;
  const at = (i: number): number => worldFromCamera[i] ?? 0;
  const place = new Float64Array(2);
  const step = 3 * Math.max(1, Math.floor(positions.length / 3 / SAMPLES));
  for (let i = 0; i + 2 < positions.length; i += step) {
    const [x, y, z] = [(positions[i] ?? 0) - at(12), (positions[i + 1] ?? 0) - at(13), (positions[i + 2] ?? 0) - at(14)];
    const depth = -(x * at(8) + y * at(9) + z * at(10));
    if (depth <= 0) continue;
    project(lens, (x * at(0) + y * at(1) + z * at(2)) / depth, -(x * at(4) + y * at(5) + z * at(6)) / depth, place);
    const [column = -1, row = -1] = place;
    if (column >= 0 && row >= 0 && column <= lens.widthPx && row <= lens.heightPx) return true;
  }
  return false;
}
