import { halfBits } from '../panorama/half-floats.ts';
import { sortedByMorton } from './morton.ts';
import { COEFFICIENTS, HARMONICS_WORDS, SplatError, type Splats, WORDS } from './splats.ts';

/** One splat, as files describe it. The reader reuses the object. */
export interface Splat {
  readonly position: Float64Array;
  /** Standard deviation along each axis of the splat. */
  readonly scale: Float64Array;
  /** Rotation, x, y, z, w; of any length. */
  readonly rotation: Float64Array;
  /** Coefficients of degree 0: red, green, blue. */
  readonly base: Float64Array;
  opacity: number;
  /** Coefficients above degree 0: red, green, blue of the first, and so on. */
  readonly harmonics: Float64Array;
}

/** The value of the spherical harmonic of degree 0. */
const C0 = 0.28209479177387814;
/** A splat that is never more opaque is not drawn. */
const LEAST_OPACITY = 1 / 255;
const MOST_COMPONENT = Math.SQRT1_2;

const scratchFloat = new Float32Array(1);
// The same four bytes.
const scratchBits = new Uint32Array(scratchFloat.buffer);

/**
 * Packs splats for the GPU, in an order in which neighbors in space are neighbors in memory. Splats that cannot be seen are left out.
 *
 * Words of a splat: x, y and z as 32-bit floats; the color at degree 0 as three half floats and the opacity as 16 bits; the scale as three
 * half floats; the rotation as its three smallest components of 15 bits and, in the two bits above the first two, the index of the largest.
 *
 * @param count Number of splats of the file.
 * @param read Reads a splat into `splat`. It is called twice for each splat with harmonics.
 * @throws SplatError if no splat is left.
 *
 * @example
 * const splats = packSplats(count, 0, false, (index, splat) => { … });
 */
export function packSplats(
  count: number,
  degree: Splats['degree'],
  antialiased: boolean,
  read: (index: number, splat: Splat) => void,
): Splats {
  const splat: Splat = {
    position: new Float64Array(3),
    scale: new Float64Array(3),
    rotation: new Float64Array(4),
    base: new Float64Array(3),
    opacity: 0,
    harmonics: new Float64Array(3 * COEFFICIENTS[degree]),
  };
  const words = new Uint32Array(count * WORDS);
  const sources = new Uint32Array(count);
  const ranges: [number, number, number] = [0, 0, 0];
  let kept = 0;
  let invalid = 0;
  for (let i = 0; i < count; i++) {
    read(i, splat);
    if (!isValid(splat)) invalid++;
    else if (splat.opacity >= LEAST_OPACITY) {
      writeWords(words, kept * WORDS, splat);
      sources[kept++] = i;
      for (let at = 0; at < splat.harmonics.length; at++) {
        const band = bandOf(at);
        ranges[band] = Math.max(ranges[band] ?? 0, Math.abs(splat.harmonics[at] ?? 0));
      }
    }
  }
  if (kept === 0) throw new SplatError(invalid > 0 ? 'none of its splats has finite values' : 'all of its splats are transparent');
  const order = sortedByMorton(words, kept);
  const sorted = new Uint32Array(kept * WORDS);
  const stride = HARMONICS_WORDS[degree];
  const harmonics = new Uint32Array(kept * stride);
  const bytes = new Uint8Array(harmonics.buffer);
  for (let to = 0; to < kept; to++) {
    const from = order[to] ?? 0;
    sorted.set(words.subarray(from * WORDS, (from + 1) * WORDS), to * WORDS);
    if (degree === 0) continue;
    read(sources[from] ?? 0, splat);
    for (let at = 0; at < splat.harmonics.length; at++) {
      const range = ranges[bandOf(at)] || 1;
      bytes[to * stride * 4 + at] = 128 + Math.round((127 * (splat.harmonics[at] ?? 0)) / range);
    }
  }
  return { count: kept, degree, antialiased, words: sorted, harmonics, ranges, invalid };
}

/** The index in `ranges` of a number of the harmonics. */
function bandOf(at: number): 0 | 1 | 2 {
  if (at < 9) return 0;
  return at < 24 ? 1 : 2;
}

function isValid({ position, scale, rotation, base, opacity, harmonics }: Splat): boolean {
  const areFinite = [position, scale, rotation, base, harmonics].every((numbers) => numbers.every(Number.isFinite));
  return areFinite && !Number.isNaN(opacity) && rotation.some((component) => component !== 0);
}

function writeWords(words: Uint32Array, at: number, { position, scale, rotation, base, opacity }: Splat): void {
  for (let axis = 0; axis < 3; axis++) {
    scratchFloat[0] = position[axis] ?? 0;
    words[at + axis] = scratchBits[0] ?? 0;
  }
  const color = (channel: number): number => signedHalf(0.5 + C0 * (base[channel] ?? 0));
  words[at + 3] = color(0) | (color(1) << 16);
  words[at + 4] = color(2) | (Math.round(65535 * Math.min(1, opacity)) << 16);
  words[at + 5] = halfBits(scale[0] ?? 0) | (halfBits(scale[1] ?? 0) << 16);
  let largest = 0;
  for (let i = 1; i < 4; i++) if (Math.abs(rotation[i] ?? 0) > Math.abs(rotation[largest] ?? 0)) largest = i;
  // Both signs are the same rotation; the largest component is not stored, so that it must be positive.
  const length = Math.hypot(...rotation) * Math.sign(rotation[largest] ?? 1);
  const component = (nth: number): number => {
    const value = (rotation[nth < largest ? nth : nth + 1] ?? 0) / length;
    return Math.round((value / MOST_COMPONENT + 1) * 0.5 * 32767);
  };
  const first = component(0) | ((largest & 1) << 15);
  const second = component(1) | ((largest >> 1) << 15);
  words[at + 6] = halfBits(scale[2] ?? 0) | (first << 16);
  words[at + 7] = second | (component(2) << 16);
}

function signedHalf(value: number): number {
  return value < 0 ? halfBits(-value) | 0x8000 : halfBits(value);
}
