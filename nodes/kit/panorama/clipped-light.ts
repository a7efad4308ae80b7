import { luminanceOf } from './sphere-grid.ts';

/** The light of a panorama whose white areas are clipped: the sum of luminance × solid angle, as the file shows it. */
export interface ClippedLight {
  /** That of the clipped areas. */
  readonly flux: number;
  /** That of all other areas. */
  readonly otherFlux: number;
}

/** The greatest factor by which clipped pixels are brightened: a single white pixel is no lamp that lights a room. */
const MAX_GAIN = 2000;
/** The constant function of the spherical harmonics (Ramamoorthi and Hanrahan 2001, eq. 3). */
const Y00 = 0.282094791773878;

/**
 * The factor on the radiance of clipped areas with which they give a part of all light. It is never less than 1, because white means “at
 * least that bright”.
 *
 * @param share The part of all light, in [0, 1).
 *
 * @example
 * gainOfShare({ flux: 1, otherFlux: 4 }, 0.5); // 4
 */
export function gainOfShare({ flux, otherFlux }: ClippedLight, share: number): number {
  return flux > 0 ? Math.min(MAX_GAIN, Math.max(1, (otherFlux * share) / (flux * (1 - share)))) : 1;
}

/** The part of a light estimate that tells brightness, as in `LightEstimate`. */
export interface EstimatedBrightness {
  readonly sphericalHarmonics: Float32Array;
  readonly primaryIntensity: Float32Array;
}

/** How bright the strongest lamp of a panorama is, as the file shows it, in luminance of irradiance. */
export interface ClippedLamp {
  /** That of its clipped pixels. */
  readonly clipped: number;
  /** That of its other pixels, less the brightness of its surroundings. */
  readonly other: number;
}

/**
 * The factor on the radiance of clipped areas with which the strongest lamp is as bright, relative to all other light, as the primary
 * light of an estimate. Other lamps that are clipped are brightened by the same factor.
 *
 * @param contrast The primary light relative to the light from all sides, see `primaryContrast`.
 *
 * @example
 * gainOfContrast({ flux: 1, otherFlux: 4 }, { clipped: 1, other: 0 }, 0.5); // 2
 */
export function gainOfContrast({ flux, otherFlux }: ClippedLight, { clipped, other }: ClippedLamp, contrast: number): number {
  // other + gain × clipped = contrast × (otherFlux - other + gain × (flux - clipped))
  const perGain = clipped - contrast * (flux - clipped);
  const wanted = contrast * (otherFlux - other) - other;
  // Brighter than this relative to other clipped lamps, it cannot become.
  if (perGain <= 0) return wanted > 0 ? MAX_GAIN : 1;
  return Math.min(MAX_GAIN, Math.max(1, wanted / perGain));
}

/**
 * The primary light of an estimate relative to all other light, which the harmonics contain.
 *
 * @returns Null for an estimate without light from all sides.
 *
 * @example
 * const contrast = primaryContrast(ctx.session.light);
 */
export function primaryContrast({ sphericalHarmonics, primaryIntensity }: EstimatedBrightness): number | null {
  const [red = 0, green = 0, blue = 0] = sphericalHarmonics;
  const [primaryRed = 0, primaryGreen = 0, primaryBlue = 0] = primaryIntensity;
  // The mean radiance of all directions is the first coefficient × Y00.
  const around = 4 * Math.PI * Y00 * luminanceOf(red, green, blue);
  const contrast = Math.max(0, luminanceOf(primaryRed, primaryGreen, primaryBlue)) / around;
  return around > 0 && Number.isFinite(contrast) ? contrast : null;
}
