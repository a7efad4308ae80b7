/** Functions for column-major 4×4 matrices that write to arrays of the caller. */

/** Near and far plane of sessions without a device, meters. */
export const NEAR_M = 0.05;
export const FAR_M = 100;

export function createMatrix(): Float32Array {
  return new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
}

/**
 * Writes a perspective projection along −z whose frustum passes through the given bounds of the plane at 1 m, as `glFrustum` defines it.
 */
export function setFrustum(out: Float32Array, left: number, right: number, bottom: number, top: number, nearM: number, farM: number): void {
  out.fill(0);
  out[0] = 2 / (right - left);
  out[5] = 2 / (top - bottom);
  out[8] = (right + left) / (right - left);
  out[9] = (top + bottom) / (top - bottom);
  out[10] = (farM + nearM) / (nearM - farM);
  out[11] = -1;
  out[14] = (2 * farM * nearM) / (nearM - farM);
}

/** Writes the inverse of a rigid transform. */
export function setRigidInverse(out: Float32Array, m: ArrayLike<number>): void {
  const at = (i: number): number => m[i] ?? 0;
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) out[column * 4 + row] = at(row * 4 + column);
    out[12 + row] = -(at(row * 4) * at(12) + at(row * 4 + 1) * at(13) + at(row * 4 + 2) * at(14));
    out[row * 4 + 3] = 0;
  }
  out[15] = 1;
}
