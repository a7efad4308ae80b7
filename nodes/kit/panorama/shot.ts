/**
 * A photo of a panorama: what the camera saw, and where it pointed. World space is that of the session; only directions matter, because
 * the photos are taken from one place.
 */
export interface PanoramaShot {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Display-referred sRGB, RGBA8, rows from the bottom. */
  readonly data: Uint8Array<ArrayBuffer>;
  /** Projection of the camera, column-major 4×4. */
  readonly clipFromView: Float32Array;
  /** Pose of the camera, column-major 4×4, rigid. */
  readonly worldFromView: Float32Array;
}

/** The lens and direction of a photo. */
export type ShotPose = Pick<PanoramaShot, 'clipFromView' | 'worldFromView'>;

/** A point of a photo; both coordinates are in [-1, 1] from the lower left. */
export interface ShotPoint {
  x: number;
  y: number;
}

/**
 * Computes the point of a photo that shows a direction.
 *
 * @param x The direction, with `y` and `z`: world space, of any length.
 * @returns Whether the photo shows it.
 *
 * @example
 * if (projectDirection(point, shot, x, y, z)) weight = edgeWeight(point);
 */
export function projectDirection(
  out: ShotPoint,
  { clipFromView: p, worldFromView: m }: ShotPose,
  x: number,
  y: number,
  z: number,
): boolean {
  const forward = -((m[8] ?? 0) * x + (m[9] ?? 0) * y + (m[10] ?? 0) * z);
  if (!(forward > 0)) return false;
  const right = (m[0] ?? 0) * x + (m[1] ?? 0) * y + (m[2] ?? 0) * z;
  const up = (m[4] ?? 0) * x + (m[5] ?? 0) * y + (m[6] ?? 0) * z;
  out.x = ((p[0] ?? 0) * right + (p[4] ?? 0) * up) / forward - (p[8] ?? 0);
  out.y = ((p[1] ?? 0) * right + (p[5] ?? 0) * up) / forward - (p[9] ?? 0);
  return out.x >= -1 && out.x <= 1 && out.y >= -1 && out.y <= 1;
}

/** Cosine of the angle between a photo's axis and its farthest corner; -1 for lenses that see more than half of all directions. */
export function cosineOfReach({ clipFromView: p }: Pick<ShotPose, 'clipFromView'>): number {
  let tangent = 0;
  for (const x of [-1, 1]) {
    for (const y of [-1, 1]) {
      tangent = Math.max(tangent, Math.hypot((x + (p[8] ?? 0)) / (p[0] ?? 1), (y + (p[9] ?? 0)) / (p[5] ?? 1)));
    }
  }
  return Number.isFinite(tangent) ? Math.cos(Math.atan(tangent)) : -1;
}

/**
 * The weight of a point of a photo, from 1 in the center to 0 at the edges. Photos blend into each other where their weights are similar.
 *
 * @example
 * edgeWeight({ x: 0, y: 0 }); // 1
 */
export function edgeWeight({ x, y }: ShotPoint): number {
  return ((1 - x * x) * (1 - y * y)) ** 3;
}

/**
 * The heading of a panorama: the rotation about y from panorama space to world space.
 *
 * @example
 * setPanoramaPose(worldFromPanorama, Math.PI / 2, [0, 1.6, 0]);
 * headingOf(worldFromPanorama); // π / 2
 */
export function headingOf(worldFromPanorama: ArrayLike<number>): number {
  return Math.atan2(worldFromPanorama[8] ?? 0, worldFromPanorama[0] ?? 1);
}

/**
 * Writes the pose of a panorama.
 *
 * @param out Column-major 4×4.
 * @param headingRad Rotation about y, counterclockwise seen from above.
 * @param at Where it was taken, meters.
 *
 * @example
 * setPanoramaPose(worldFromPanorama, 0, [0, 1.6, 0]); // the center of the panorama is along -z
 */
export function setPanoramaPose(out: Float32Array, headingRad: number, [x = 0, y = 0, z = 0]: readonly number[]): void {
  const [cos, sin] = [Math.cos(headingRad), Math.sin(headingRad)];
  out.set([cos, 0, -sin, 0, 0, 1, 0, 0, sin, 0, cos, 0, x, y, z, 1]);
}
