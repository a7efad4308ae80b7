/**
 * Rotates spherical harmonics from the axes of a light probe to those of the world. Band 1 is a linear form v · n, and v rotates as a
 * vector. Band 2 is a quadratic form n · M n without trace, and M becomes R M Rᵀ.
 *
 * @param out 9 coefficients × RGB in the order of WebXR Lighting Estimation §3.2; may be `from`.
 * @param worldFromLight Pose, column-major 4×4; only its rotation is used.
 */
export function rotateHarmonics(out: Float32Array, from: Float32Array, worldFromLight: Float32Array): void {
  for (let i = 0; i < 9; i++) scratchRotation[i] = worldFromLight[Math.floor(i / 3) + (i % 3) * 4] ?? 0;
  for (let channel = 0; channel < 3; channel++) {
    const x = at(from, 9 + channel);
    const y = at(from, 3 + channel);
    const z = at(from, 6 + channel);
    for (let row = 0; row < 3; row++) {
      const turned = at(scratchRotation, row * 3) * x + at(scratchRotation, row * 3 + 1) * y + at(scratchRotation, row * 3 + 2) * z;
      out[(VECTOR_AT[row] ?? 0) + channel] = turned;
    }
    setForm(scratchForm, from, channel);
    setTimes(scratchHalf, scratchRotation, scratchForm);
    setTimesTransposed(scratchForm, scratchHalf, scratchRotation);
    out[12 + channel] = at(scratchForm, 1);
    out[15 + channel] = at(scratchForm, 5);
    out[18 + channel] = at(scratchForm, 8) * HALF_ROOT_3;
    out[21 + channel] = at(scratchForm, 2);
    out[24 + channel] = (at(scratchForm, 0) - at(scratchForm, 4)) / 2;
    out[channel] = at(from, channel);
  }
}

const HALF_ROOT_3 = Math.sqrt(3) / 2;
/** Indices of the coefficients of band 1 that belong to x, y and z. */
const VECTOR_AT: readonly number[] = [9, 3, 6];

/** Row-major 3×3 matrices, valid within one call. */
const scratchRotation = new Float64Array(9);
const scratchForm = new Float64Array(9);
const scratchHalf = new Float64Array(9);

function at(numbers: Float32Array | Float64Array, i: number): number {
  return numbers[i] ?? 0;
}

/**
 * Reads band 2 as a symmetric matrix, in units of the factor of the basis function x² − y². The factor of products is twice that, and each
 * product is in two entries; the factor of 3z² − 1 is 1/√3 of it.
 */
function setForm(out: Float64Array, from: Float32Array, channel: number): void {
  const third = at(from, 18 + channel) / Math.sqrt(3);
  const difference = at(from, 24 + channel);
  out[0] = difference - third;
  out[4] = -difference - third;
  out[8] = 2 * third;
  out[1] = at(from, 12 + channel);
  out[3] = at(from, 12 + channel);
  out[5] = at(from, 15 + channel);
  out[7] = at(from, 15 + channel);
  out[2] = at(from, 21 + channel);
  out[6] = at(from, 21 + channel);
}

function setTimes(out: Float64Array, a: Float64Array, b: Float64Array): void {
  for (let i = 0; i < 9; i++) {
    const column = i % 3;
    const row = i - column;
    out[i] = at(a, row) * at(b, column) + at(a, row + 1) * at(b, column + 3) + at(a, row + 2) * at(b, column + 6);
  }
}

function setTimesTransposed(out: Float64Array, a: Float64Array, b: Float64Array): void {
  for (let i = 0; i < 9; i++) {
    const row = i - (i % 3);
    const other = (i % 3) * 3;
    out[i] = at(a, row) * at(b, other) + at(a, row + 1) * at(b, other + 1) + at(a, row + 2) * at(b, other + 2);
  }
}
