/** Poses on surfaces: their axes, and which way a surface faces. */

/**
 * A surface whose normal is within this angle of the vertical is level; one whose normal is within this angle of the horizontal is upright.
 */
const LEVEL_RAD = (20 * Math.PI) / 180;
const COS_LEVEL = Math.cos(LEVEL_RAD);
const SIN_UPRIGHT = Math.sin(LEVEL_RAD);
const COS_45 = Math.SQRT1_2;

export type SurfaceOrientation = 'floor' | 'wall' | 'ceiling' | 'sloped';

/**
 * Which way a surface faces, by its normal: `floor` (tables too) if the normal points up within 20°, `ceiling` if it points down within
 * 20°, `wall` if it is horizontal within 20°, otherwise `sloped`.
 *
 * @param worldFromHit Column-major 4×4, rigid, whose y axis is the normal.
 *
 * @example
 * const isFloor = surfaceOrientation(hit.worldFromHit) === 'floor';
 */
export function surfaceOrientation(worldFromHit: ArrayLike<number>): SurfaceOrientation {
  const up = worldFromHit[5] ?? 0;
  if (up >= COS_LEVEL) return 'floor';
  if (up <= -COS_LEVEL) return 'ceiling';
  return Math.abs(up) <= SIN_UPRIGHT ? 'wall' : 'sloped';
}

/**
 * Writes the pose of a point on a surface: y along the normal, flipped to the side from which the ray comes. On surfaces that lie level
 * within 45°, z points to the viewer; on steeper ones z points down along the surface. x is to the right as the viewer sees it.
 *
 * @param out Receives the column-major 4×4.
 * @param px, py, pz The point, world space, meters.
 * @param nx, ny, nz The surface's normal, world space, of any length except 0.
 * @param fromX, fromY, fromZ The ray's origin, world space: the side that the normal is turned to.
 * @param eyeX, eyeZ The viewer, world space.
 *
 * @example
 * setSurfacePose(hit.worldFromHit, 0, 0, -2, 0, 1, 0, 0, 1.6, 0, 0, 0);
 */
export function setSurfacePose(
  out: Float32Array,
  px: number,
  py: number,
  pz: number,
  nx: number,
  ny: number,
  nz: number,
  fromX: number,
  fromY: number,
  fromZ: number,
  eyeX: number,
  eyeZ: number,
): void {
  const side = nx * (fromX - px) + ny * (fromY - py) + nz * (fromZ - pz) < 0 ? -1 : 1;
  const scale = side / Math.hypot(nx, ny, nz);
  const yx = nx * scale;
  const yy = ny * scale;
  const yz = nz * scale;
  const lies = Math.abs(yy) >= COS_45;
  // The direction that z follows, before the normal's part is taken off.
  let zx = lies ? eyeX - px : 0;
  let zy = lies ? 0 : -1;
  let zz = lies ? eyeZ - pz : 0;
  // Directly below or above the viewer the direction is undefined: use +z.
  if (lies && Math.hypot(zx, zz) < 1e-4) {
    zx = 0;
    zz = 1;
  }
  const along = zx * yx + zy * yy + zz * yz;
  zx -= along * yx;
  zy -= along * yy;
  zz -= along * yz;
  const length = Math.hypot(zx, zy, zz);
  zx /= length;
  zy /= length;
  zz /= length;
  out[0] = yy * zz - yz * zy;
  out[1] = yz * zx - yx * zz;
  out[2] = yx * zy - yy * zx;
  out[3] = 0;
  out[4] = yx;
  out[5] = yy;
  out[6] = yz;
  out[7] = 0;
  out[8] = zx;
  out[9] = zy;
  out[10] = zz;
  out[11] = 0;
  out[12] = px;
  out[13] = py;
  out[14] = pz;
  out[15] = 1;
}
