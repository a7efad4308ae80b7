/** Rotations and rigid transforms. Matrices are column-major 4×4; quaternions are x, y, z, w, of length 1. */

/** A vector that is shorter counts as having no direction. */
const TINY = 1e-6;

/**
 * Writes a rotation by angles about each axis, applied about z first, then x, then y (`YXZ` in three.js), and a position.
 *
 * @param rotationRad Three angles about x, y and z, radians, counterclockwise seen from the tip of the axis.
 *
 * @example
 * setFromAngles(matrix, [0, 1, 0], [0, Math.PI / 2, 0]); // x of the transform is -z
 */
export function setFromAngles(out: Float32Array, position: ArrayLike<number>, rotationRad: ArrayLike<number>): void {
  const cx = Math.cos(rotationRad[0] ?? 0);
  const sx = Math.sin(rotationRad[0] ?? 0);
  const cy = Math.cos(rotationRad[1] ?? 0);
  const sy = Math.sin(rotationRad[1] ?? 0);
  const cz = Math.cos(rotationRad[2] ?? 0);
  const sz = Math.sin(rotationRad[2] ?? 0);
  setAxis(out, 0, cy * cz + sy * sx * sz, cx * sz, cy * sx * sz - sy * cz);
  setAxis(out, 1, sy * sx * cz - cy * sz, cx * cz, sy * sz + cy * sx * cz);
  setAxis(out, 2, sy * cx, -sx, cy * cx);
  setPosition(out, position[0] ?? 0, position[1] ?? 0, position[2] ?? 0);
}

/**
 * Turns a pose so that its z axis points along a direction, with y as far up as that allows. The position stays. If the direction is
 * straight up or down, the x axis of the pose is kept as far as possible; a direction without length changes nothing.
 *
 * @param matrix Rigid; changed in place.
 * @param x, y, z The direction, of any length.
 * @returns False for a direction without length.
 *
 * @example
 * aimZ(matrix, 1, 0, 0);
 */
export function aimZ(matrix: Float32Array, x: number, y: number, z: number): boolean {
  const size = Math.hypot(x, y, z);
  if (!(size > TINY)) return false;
  const zx = x / size;
  const zy = y / size;
  const zz = z / size;
  // x = up × z, which is level.
  let xx = zz;
  let xy = 0;
  let xz = -zx;
  if (Math.hypot(xx, xz) < TINY) {
    // The pose's own x axis, without its part along z; its y axis where x is parallel to z.
    const from = Math.abs(matrix[1] ?? 0) < 0.9 ? 0 : 4;
    xx = matrix[from] ?? 0;
    xy = 0;
    xz = matrix[from + 2] ?? 0;
  }
  const level = Math.hypot(xx, xy, xz);
  xx /= level;
  xz /= level;
  setAxis(matrix, 0, xx, xy, xz);
  setAxis(matrix, 1, zy * xz - zz * xy, zz * xx - zx * xz, zx * xy - zy * xx);
  setAxis(matrix, 2, zx, zy, zz);
  return true;
}

/**
 * Writes the rotation of a rigid matrix as a quaternion (Shepperd's method: the largest component is computed first).
 *
 * @example
 * setQuaternion(q, pose.worldFromPose);
 */
export function setQuaternion(out: Float64Array, matrix: ArrayLike<number>): void {
  const m = (i: number) => matrix[i] ?? 0;
  const trace = m(0) + m(5) + m(10);
  if (trace > m(0) && trace > m(5) && trace > m(10)) {
    setComponents(out, m(6) - m(9), m(8) - m(2), m(1) - m(4), 1 + trace);
  } else if (m(0) >= m(5) && m(0) >= m(10)) {
    setComponents(out, 1 + m(0) - m(5) - m(10), m(1) + m(4), m(8) + m(2), m(6) - m(9));
  } else if (m(5) >= m(10)) {
    setComponents(out, m(1) + m(4), 1 - m(0) + m(5) - m(10), m(6) + m(9), m(8) - m(2));
  } else {
    setComponents(out, m(8) + m(2), m(6) + m(9), 1 - m(0) - m(5) + m(10), m(1) - m(4));
  }
}

/**
 * Turns a quaternion toward another along the shorter arc, at constant angular speed (Shoemake 1985, slerp).
 *
 * @param q Changed in place.
 * @param part 0 keeps `q`, 1 gives `to`.
 *
 * @example
 * turnToward(q, target, 0.5);
 */
export function turnToward(q: Float64Array, to: Float64Array, part: number): void {
  let cosine = 0;
  for (let i = 0; i < 4; i++) cosine += (q[i] ?? 0) * (to[i] ?? 0);
  const side = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  // Of nearly the same rotations the line is as good as the arc.
  const sine = Math.sin(angle);
  const keep = sine > TINY ? Math.sin((1 - part) * angle) / sine : 1 - part;
  const take = side * (sine > TINY ? Math.sin(part * angle) / sine : part);
  const at = (i: number) => (q[i] ?? 0) * keep + (to[i] ?? 0) * take;
  setComponents(q, at(0), at(1), at(2), at(3));
}

/**
 * Writes a rigid matrix.
 *
 * @param position Three numbers, meters.
 *
 * @example
 * setRigid(matrix, position, q);
 */
export function setRigid(out: Float32Array, position: ArrayLike<number>, quaternion: ArrayLike<number>): void {
  const x = quaternion[0] ?? 0;
  const y = quaternion[1] ?? 0;
  const z = quaternion[2] ?? 0;
  const w = quaternion[3] ?? 1;
  setAxis(out, 0, 1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w));
  setAxis(out, 1, 2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w));
  setAxis(out, 2, 2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y));
  setPosition(out, position[0] ?? 0, position[1] ?? 0, position[2] ?? 0);
}

function setAxis(out: Float32Array, column: number, x: number, y: number, z: number): void {
  out[column * 4] = x;
  out[column * 4 + 1] = y;
  out[column * 4 + 2] = z;
  out[column * 4 + 3] = 0;
}

function setPosition(out: Float32Array, x: number, y: number, z: number): void {
  out[12] = x;
  out[13] = y;
  out[14] = z;
  out[15] = 1;
}

function setComponents(out: Float64Array, x: number, y: number, z: number, w: number): void {
  const size = Math.hypot(x, y, z, w);
  out[0] = x / size;
  out[1] = y / size;
  out[2] = z / size;
  out[3] = w / size;
}
