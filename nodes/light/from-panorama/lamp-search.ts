import type { EnvironmentAsset } from '../../kit/assets.ts';
import type { FoundLamps } from '../../kit/panorama/found-lamps.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';

/** Searches a panorama in slices, so that the picture is never blocked. */
export interface LampSearch {
  /**
   * Call it once per frame.
   *
   * @param whole Whether to complete the search in this frame, as in a render.
   * @returns The result; null until the search is complete.
   */
  step(whole: boolean): FoundLamps | null;
}

/** Slices of about a millisecond per frame. */
const SLICES = 6;

/** Starts a search, which is a generator that yields after about a millisecond of work. Drop it to cancel it. */
export function createLampSearch(
  environment: EnvironmentAsset,
  find: (pixels: PanoramaPixels) => Generator<undefined, FoundLamps>,
): LampSearch {
  const slices = find(environment.readPixels());
  let result: FoundLamps | null = null;
  return {
    step: (whole) => {
      for (let i = 0; result === null && (whole || i < SLICES); i++) {
        const { done, value } = slices.next();
        if (done) result = value;
      }
      return result;
    },
  };
}
