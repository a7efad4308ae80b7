import type { FoundLamps } from './found-lamps.ts';
import type { LampOptions } from './lamp-options.ts';
import { findByPaper } from './paper-method.ts';
import type { PanoramaPixels } from './pixels.ts';
import { findBySolidAngle } from './solid-angle-method.ts';

/**
 * Searches a panorama by the method of the options. It yields after about a millisecond of work.
 *
 * @example
 * const search = findLamps(pixels, { method: 'solid-angle', lamps: 3, iterations: 2, intensities: 'ranks', clippedShare: 0.5 });
 */
export function findLamps(pixels: PanoramaPixels, options: LampOptions): Generator<undefined, FoundLamps> {
  return options.method === 'paper' ? findByPaper(pixels, options) : findBySolidAngle(pixels, options);
}

/**
 * Runs a search to its end and returns its result.
 *
 * @param onPart Receives the part that is done, in [0, 1], a few times. It is estimated from the number of steps.
 *
 * @example
 * const found = searchWhole(findLamps(pixels, options));
 */
export function searchWhole(
  search: Generator<undefined, FoundLamps>,
  { heightPx }: Pick<PanoramaPixels, 'heightPx'> = { heightPx: 0 },
  onPart: (part: number) => void = () => {},
): FoundLamps {
  // Most steps are of 32 rows, and most methods pass over the image about four times.
  const expected = Math.max(1, (heightPx / 32) * 4);
  const every = Math.ceil(expected / 10);
  for (let steps = 0; ; steps++) {
    const { done, value } = search.next();
    if (done) return value;
    if (steps % every === 0) onPart(Math.min(1, steps / expected));
  }
}

/**
 * Finds the lamps of a panorama synchronously, and returns the parts of the result that a page needs.
 *
 * @example
 * const { lamps } = findLampsAtOnce(pixels, lampOptionsOf(ctx.config));
 */
export function findLampsAtOnce(pixels: PanoramaPixels, options: LampOptions): FoundLamps {
  return storedLamps(searchWhole(findLamps(pixels, options)));
}

/** Reduces a result to what a page needs: drops the images and contours, which only the editor shows. */
export function storedLamps(found: FoundLamps): FoundLamps {
  return { ...found, lamps: found.lamps.map((lamp) => ({ ...lamp, contour: [] })), steps: [] };
}
