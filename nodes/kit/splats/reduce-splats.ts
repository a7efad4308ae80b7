import { fromHalfBits } from '../panorama/half-floats.ts';
import type { SplatSize } from './splat-size.ts';
import { HARMONICS_WORDS, type Splats, WORDS } from './splats.ts';

const scratchFloat = new Float32Array(1);
// The same four bytes. The bits of numbers that are not negative have the order of the numbers.
const scratchBits = new Uint32Array(scratchFloat.buffer);

/**
 * Reduces splats to a size. Harmonics above its degree are dropped; the colors of the lower degrees stay. Of the splats, those with the most
 * opacity times area stay, in their order: a splat that covers little of any image, or hardly covers it, is missed least. The same splats give
 * the same result.
 *
 * @param size At most that of the splats (`splatSize`).
 *
 * @example
 * const shown = reduceSplats(splats, splatSize(splats.count, splats.degree, 64e6));
 */
export function reduceSplats(splats: Splats, { count, degree }: Pick<SplatSize, 'count' | 'degree'>): Splats {
  if (count >= splats.count && degree >= splats.degree) return splats;
  const kept = count < splats.count ? mostImportant(splats, count) : null;
  return {
    ...splats,
    count,
    degree,
    words: gather(splats.words, WORDS, WORDS, count, kept),
    // The coefficients of lower degrees come first.
    harmonics: gather(splats.harmonics, HARMONICS_WORDS[splats.degree], HARMONICS_WORDS[degree], count, kept),
  };
}

/** Copies the first `width` of the `stride` words of each kept splat. */
function gather(from: Splats['words'], stride: number, width: number, count: number, kept: Uint32Array | null): Splats['words'] {
  if (kept === null && width === stride) return from;
  const to = new Uint32Array(count * width);
  for (let i = 0; i < count; i++) {
    const start = stride * (kept === null ? i : (kept[i] as number));
    for (let word = 0; word < width; word++) to[i * width + word] = from[start + word] as number;
  }
  return to;
}

/** The indices of the most important splats, ascending. Of equally important ones, the first stay. */
function mostImportant({ words, count: all }: Splats, count: number): Uint32Array {
  // Two passes over 16 bits each find the least importance that stays. Sorting would take 16 bytes per splat.
  const histogram = new Uint32Array(1 << 16);
  let least = 0;
  let room = count;
  for (const shift of [16, 0]) {
    histogram.fill(0);
    for (let i = 0; i < all; i++) {
      const bits = importanceBits(words, i * WORDS);
      if (shift === 16 || bits >>> 16 === least >>> 16) {
        const bucket = (bits >>> shift) & 0xffff;
        histogram[bucket] = (histogram[bucket] as number) + 1;
      }
    }
    let bucket = 0xffff;
    while (bucket > 0 && (histogram[bucket] as number) < room) room -= histogram[bucket--] as number;
    least |= bucket << shift;
  }
  const kept = new Uint32Array(count);
  let at = 0;
  for (let i = 0; i < all; i++) {
    const bits = importanceBits(words, i * WORDS);
    if (bits > least || (bits === least && room-- > 0)) kept[at++] = i;
  }
  return kept;
}

/** Opacity times area, as the bits of a 32-bit float. The area is that of the three faces of the box around the ellipsoid. */
function importanceBits(words: Uint32Array, at: number): number {
  const scales = words[at + 5] as number;
  const a = fromHalfBits(scales & 0xffff);
  const b = fromHalfBits(scales >>> 16);
  const c = fromHalfBits((words[at + 6] as number) & 0xffff);
  scratchFloat[0] = ((words[at + 4] as number) >>> 16) * (a * b + b * c + c * a);
  return scratchBits[0] as number;
}
