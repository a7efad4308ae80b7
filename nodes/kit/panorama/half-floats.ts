const scratchFloat = new Float32Array(1);
// The same four bytes.
const scratchBits = new Uint32Array(scratchFloat.buffer);

/** The largest half float. */
const MOST = 65504;
/** Below 2^-14, half floats have fewer digits. */
const LEAST_NORMAL = 2 ** -14;

/**
 * The bits of the half float (IEEE 754 binary16) next to a number that is not negative; of larger numbers those of 65504, and of NaN those
 * of 0.
 *
 * @example
 * halfBits(1); // 0x3c00
 */
export function halfBits(value: number): number {
  if (!(value > 0)) return 0;
  if (value >= MOST) return 0x7bff;
  if (value < LEAST_NORMAL) return Math.round(value * 2 ** 24);
  scratchFloat[0] = value;
  // 23 bits of fraction become 10, rounded; the exponent is biased by 15 instead of 127.
  return ((scratchBits[0] ?? 0) + 0x1000 - ((127 - 15) << 23)) >>> 13;
}

/**
 * The number of a half float that is not negative and finite.
 *
 * @example
 * fromHalfBits(0x3c00); // 1
 */
export function fromHalfBits(bits: number): number {
  if (bits < 0x400) return bits * 2 ** -24;
  scratchBits[0] = (bits << 13) + ((127 - 15) << 23);
  return scratchFloat[0] ?? 0;
}

/**
 * Converts linear radiance with three channels to half floats with four, of which the last is 1.
 *
 * @param radiance Three numbers per pixel.
 *
 * @example
 * const data = halvesWithAlpha(merged.data);
 */
export function halvesWithAlpha(radiance: Float32Array): Uint16Array<ArrayBuffer> {
  const halves = new Uint16Array((radiance.length / 3) * 4);
  for (let from = 0, to = 0; from < radiance.length; from += 3, to += 4) {
    halves[to] = halfBits(radiance[from] ?? 0);
    halves[to + 1] = halfBits(radiance[from + 1] ?? 0);
    halves[to + 2] = halfBits(radiance[from + 2] ?? 0);
    halves[to + 3] = 0x3c00;
  }
  return halves;
}
