/** The 3×3 identity matrix, column-major: the UV matrix of an image that is aligned with the view. */
export const IDENTITY: Float32Array = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/**
 * Multiplies two column-major 4×4 matrices: `out = a * b`.
 *
 * @param out Receives the product, 16 numbers; it must be neither `a` nor `b`.
 *
 * @example
 * multiplyMatrices(clipFromWorld, clipFromView, viewFromWorld);
 */
export function multiplyMatrices(out: Float32Array, a: Float32Array, b: Float32Array): void {
  for (let column = 0; column < 16; column += 4) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let i = 0; i < 4; i++) sum += (a[i * 4 + row] ?? 0) * (b[column + i] ?? 0);
      out[column + row] = sum;
    }
  }
}

/**
 * Inverts a column-major 3×3 matrix by its adjugate.
 *
 * @param out Receives the inverse, 9 numbers, or zeros if `m` is singular; it must not be `m`.
 *
 * @example
 * setInverse3(viewUvFromUv, uvFromViewUv);
 */
export function setInverse3(out: Float32Array, m: Float32Array): void {
  const a = m[0] ?? 0;
  const b = m[1] ?? 0;
  const c = m[2] ?? 0;
  const d = m[3] ?? 0;
  const e = m[4] ?? 0;
  const f = m[5] ?? 0;
  const g = m[6] ?? 0;
  const h = m[7] ?? 0;
  const i = m[8] ?? 0;
  const determinant = a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e);
  const scale = determinant === 0 ? 0 : 1 / determinant;
  out[0] = (e * i - f * h) * scale;
  out[1] = (c * h - b * i) * scale;
  out[2] = (b * f - c * e) * scale;
  out[3] = (f * g - d * i) * scale;
  out[4] = (a * i - c * g) * scale;
  out[5] = (c * d - a * f) * scale;
  out[6] = (d * h - e * g) * scale;
  out[7] = (b * g - a * h) * scale;
  out[8] = (a * e - b * d) * scale;
}
