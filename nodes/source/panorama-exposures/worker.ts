import { halvesWithAlpha } from '../../kit/panorama/half-floats.ts';
import { mergeExposures } from '../../kit/panorama/merge-exposures.ts';
import { type PanoramaPixels, runWhole } from '../../kit/panorama/pixels.ts';

/** The message from the runtime to its worker: the shots to merge. */
export interface MergeTask {
  readonly shots: readonly PanoramaPixels[];
  readonly stopsApart: number;
}

/** A merged panorama, ready to be shown. */
export interface Merged {
  /** Half floats with four channels. */
  readonly pixels: PanoramaPixels & { readonly data: Uint16Array<ArrayBuffer> };
  /** Part of the sphere that is white in all shots, in [0, 1]. */
  readonly whitePart: number;
}

/** The message from the worker. `failure` is text for users. */
export type MergeAnswer = { readonly merged: Merged } | { readonly failure: string };

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: MergeTask }) => void) | null;
  postMessage(answer: MergeAnswer, transfer: ArrayBuffer[]): void;
}

/** Merges shots in a worker. */
export function serve(scope: WorkerScope): void {
  scope.onmessage = ({ data }) => {
    try {
      const merged = merge(data);
      scope.postMessage({ merged }, [merged.pixels.data.buffer]);
    } catch (error) {
      scope.postMessage({ failure: error instanceof Error ? error.message : String(error) }, []);
    }
  };
}

/**
 * Merges shots synchronously, as renders do.
 *
 * @throws Error for shots that cannot be merged, with a reason for users.
 */
export function merge({ shots, stopsApart }: MergeTask): Merged {
  const { widthPx, heightPx, data, whitePart } = runWhole(mergeExposures(shots, stopsApart));
  return { pixels: { widthPx, heightPx, channels: 4, data: halvesWithAlpha(data) }, whitePart };
}
