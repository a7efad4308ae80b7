import { findLampsAtOnce } from '../../kit/panorama/find-lamps.ts';
import type { FoundLamps } from '../../kit/panorama/found-lamps.ts';
import type { LampOptions } from '../../kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';

/** The message from the runtime to its worker: one search. To cancel a search, the runtime ends the worker. */
export interface SearchMessage {
  readonly pixels: PanoramaPixels;
  readonly options: LampOptions;
}

/** The message from the worker. */
export type SearchAnswer = { readonly found: FoundLamps } | { readonly failure: string };

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: SearchMessage }) => void) | null;
  postMessage(answer: SearchAnswer): void;
}

/** Searches panoramas in a worker: answers each message with its result. */
export function serve(scope: WorkerScope): void {
  scope.onmessage = ({ data: { pixels, options } }) => {
    try {
      scope.postMessage({ found: findLampsAtOnce(pixels, options) });
    } catch (error) {
      scope.postMessage({ failure: error instanceof Error ? error.message : String(error) });
    }
  };
}
