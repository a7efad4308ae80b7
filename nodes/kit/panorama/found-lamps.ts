import type { ClippedLight } from './clipped-light.ts';
import type { Contour } from './outer-contours.ts';

/** A lamp that was found in a panorama. Directions are in panorama space: the center is -z, the right half +x, up +y. */
export interface FoundLamp {
  /** Unit vector from the scene towards the lamp. */
  readonly towards: readonly [x: number, y: number, z: number];
  /** Linear-sRGB irradiance of a surface that faces the lamp; π renders a white matte surface as white. */
  readonly irradiance: readonly [red: number, green: number, blue: number];
  /**
   * The part of `irradiance` that clipped pixels give, before they are brightened: as much as the file shows. Absent where it is not
   * measured.
   */
  readonly clippedIrradiance?: readonly [red: number, green: number, blue: number];
  /** Angular diameter of a disk with the solid angle of the lamp. */
  readonly sizeRad: number;
  /** Area in pixels of the analyzed image, whose size is `FoundLamps.widthPx` × `heightPx`. */
  readonly areaPx: number;
  /** Center of the lamp's area, pixels from the top left; pixel centers are at integers. */
  readonly centerPx: readonly [x: number, y: number];
  readonly contour: Contour;
  /** The iteration that found it, from 0. */
  readonly iteration: number;
  /** The fraction of the lamp's pixels that are clipped to white, so that their true brightness is unknown. */
  readonly clippedPart: number;
}

/** Why no lamp was found; `DESCRIPTIONS` has the sentences. */
export type NoLamps = 'black' | 'bright-all-over' | 'too-much-above' | 'lost-in-median' | 'none-stands-out';

/** One iteration of the paper's method, for the editor. */
export interface LampStep {
  /** For each level of gray, the number of pixels that are not masked. */
  readonly histogram: Uint32Array;
  readonly max: number;
  readonly mean: number;
  /** Pixels are bright above this level. */
  readonly threshold: number;
  /** Pixels above the threshold, as a part of those that are not masked. */
  readonly abovePart: number;
  /** Masks, rows from the top: `bright` has the pixels above the threshold, `smooth` is its median. */
  readonly bright: Uint8Array;
  readonly smooth: Uint8Array;
  /** Outer contours, including those without area. */
  readonly contours: readonly Contour[];
}

/** The result of an analysis. */
export interface FoundLamps {
  /** Size of the analyzed image, which may be smaller than the panorama. */
  readonly widthPx: number;
  readonly heightPx: number;
  /** The strongest first. */
  readonly lamps: readonly FoundLamp[];
  /** Lamps about as bright as these that stay in the rest, because there are more than wanted; absent if there are none. */
  readonly more?: number;
  /** Why no lamp was found; null if there are lamps. */
  readonly none: NoLamps | null;
  /** The pixels of the lamps, as `[y, first x, last x + 1, …]` in the analyzed image. */
  readonly runs: readonly number[];
  /** The light that the rest of the panorama gives a floor, as that of one wide lamp above; null if it was not measured. */
  readonly rest: Pick<FoundLamp, 'towards' | 'irradiance'> | null;
  /** The clipped light of the panorama, and the factor by which it was brightened; absent or null where nothing is clipped. */
  readonly clipped?: (ClippedLight & { readonly gain: number }) | null;
  /** Pixels whose radiance is not a number, infinite or negative. */
  readonly damaged: number;
  /** The iterations; empty for the method by solid angle. */
  readonly steps: readonly LampStep[];
}

/** The sentences for users that tell why no lamp was found. */
export const NO_LAMPS: Readonly<Record<NoLamps, string>> = {
  black: 'the panorama is black',
  'bright-all-over': 'the panorama is too bright all over to tell lamps from walls',
  'too-much-above': 'more than 2 % of the panorama is nearly as bright as its brightest pixel, too much for lamps',
  'lost-in-median': 'it has no lamp larger than the window of the median, 5 × 5 pixels',
  'none-stands-out': 'no part of it is much brighter than the rest',
};

/**
 * The direction of a point of a panorama.
 *
 * @param x Pixels from the left; pixel centers are at integers.
 * @param y Pixels from the top.
 * @returns A unit vector in panorama space.
 *
 * @example
 * directionAt(512, 256, 1024, 512); // [0, 0, -1]
 */
export function directionAt(x: number, y: number, widthPx: number, heightPx: number): [x: number, y: number, z: number] {
  const theta = longitudeAt(x, widthPx);
  const phi = latitudeAt(y, heightPx);
  return [Math.sin(theta) * Math.cos(phi), Math.sin(phi), -Math.cos(theta) * Math.cos(phi)];
}

/**
 * θ: the angle to the right of the center (ARPAS 2018, equation 5), radians.
 *
 * @example
 * longitudeAt(768, 1024); // π / 2: to the right
 */
export function longitudeAt(x: number, widthPx: number): number {
  return ((x - widthPx / 2) / (widthPx / 2)) * Math.PI;
}

/**
 * φ: the angle above the horizon (ARPAS 2018, equation 6), radians.
 *
 * @example
 * latitudeAt(0, 512); // π / 2: the zenith
 */
export function latitudeAt(y: number, heightPx: number): number {
  return ((heightPx / 2 - y) / (heightPx / 2)) * (Math.PI / 2);
}
