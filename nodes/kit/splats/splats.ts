/**
 * Gaussian splats in the layout that the GPU reads (Kerbl et al., “3D Gaussian Splatting for Real-Time Radiance Field Rendering”, 2023).
 * Lengths are in units of the file, colors are display-referred sRGB.
 */
export interface Splats {
  readonly count: number;
  /** Degree of the spherical harmonics of the color, from 0 (the color is the same from all sides) to 3. */
  readonly degree: 0 | 1 | 2 | 3;
  /** Whether the splats were trained with an opacity that compensates for the low-pass filter. */
  readonly antialiased: boolean;
  /** `WORDS` 32-bit words per splat, see `splat-packer.ts`. */
  readonly words: Uint32Array<ArrayBuffer>;
  /** `HARMONICS_WORDS[degree]` words per splat: the coefficients above degree 0 as bytes, three channels each, 128 is 0. */
  readonly harmonics: Uint32Array<ArrayBuffer>;
  /** What the byte 255 of a coefficient of degree 1, 2 and 3 stands for. */
  readonly ranges: readonly [number, number, number];
  /** Number of splats of the file that were left out, because a value of theirs is not finite. */
  readonly invalid: number;
}

/** Words per splat. */
export const WORDS = 8;
/** Words per splat of the harmonics by degree. */
export const HARMONICS_WORDS = [0, 4, 8, 12] as const;
/** Splats per row of the textures. */
export const SPLATS_PER_ROW = 1024;
/** Coefficients above degree 0 by degree; there are three numbers for each. */
export const COEFFICIENTS = [0, 3, 8, 15] as const;

/**
 * Numbers of splats: the most that are shown, and above which visitors with phones and headsets are warned of. In headsets, each splat is
 * drawn for two eyes.
 */
export const SPLAT_LIMITS = { most: 4_000_000, phone: 1_000_000, headset: 500_000 } as const;

/** A problem of a file of splats. The message is the end of a sentence for users, without its full stop. */
export class SplatError extends Error {
  override readonly name = 'SplatError';
  /** The remedy, as a sentence. */
  readonly fix: string;

  constructor(message: string, fix = 'Export it again from the program that made it.') {
    super(message);
    this.fix = fix;
  }
}

/**
 * Checks the number of splats that a file announces.
 *
 * @throws SplatError
 *
 * @example
 * checkCount(1_000_000);
 */
export function checkCount(count: number): void {
  if (!Number.isInteger(count) || count < 0) throw new SplatError('its number of splats is invalid');
  if (count === 0) throw new SplatError('it has no splats');
  const { most } = SPLAT_LIMITS;
  if (count > most)
    throw new SplatError(`it has ${count} splats, but at most ${most} can be shown`, 'Remove splats in an editor for splats.');
}

/**
 * The bytes that splats take on the GPU: data, harmonics and order.
 *
 * @example
 * splatGpuBytes(500_000, 0); // 18 MB
 */
export function splatGpuBytes(count: number, degree: Splats['degree']): number {
  return count * 4 * (WORDS + HARMONICS_WORDS[degree] + 1);
}
