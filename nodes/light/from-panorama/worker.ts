import { findLampsAtOnce } from '../../kit/panorama/find-lamps.ts';
import type { FoundLamps } from '../../kit/panorama/found-lamps.ts';
import type { LampOptions } from '../../kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';

/** What the runtime sends its worker: one search. Ending the worker cancels it. */
export interface SearchMessage {
  readonly pixels: PanoramaPixels;
  readonly options: LampOptions;
}

/** What the worker answers. */
export type SearchAnswer = { readonly found: FoundLamps } | { readonly failure: string };

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: SearchMessage }) => void) | null;
  postMessage(answer: SearchAnswer): void;
}

/** Searches panoramas in a worker: one answer for each message. */
export function serve(scope: WorkerScope): void {
  scope.onmessage = ({ data: { pixels, options } }) => {
    try {
      scope.postMessage({ found: findLampsAtOnce(pixels, options) });
    } catch (error) {
      scope.postMessage({ failure: error instanceof Error ? error.message : String(error) });
    }
  };
}
