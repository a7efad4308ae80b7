import type { EnvironmentAsset } from '../../kit/assets.ts';
import type { FoundLamps } from '../../kit/panorama/found-lamps.ts';
import { type LampOptions, lampKey } from '../../kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';
import type { NodeWorker, WorkerService } from '../../kit/runtime.ts';
import type { SearchAnswer, SearchMessage } from './worker.ts';

/** A search for the lamps of a panorama that never blocks a frame. */
export interface LampSearch {
  /**
   * Asks for the result. Call it once per frame.
   *
   * @returns The result; null while the search is running.
   * @throws Error if the search has failed, with a reason for users.
   */
  take(): FoundLamps | null;
  /** Cancels the search. */
  dispose(): void;
}

/**
 * Starts a search. A result that the program stores is used at once. In a render, where every frame has to be complete, the panorama is
 * searched synchronously. Otherwise a worker searches it.
 */
export function startLampSearch(environment: EnvironmentAsset, options: LampOptions, workers: WorkerService, held: boolean): LampSearch {
  const stored = environment.lamps?.[lampKey(options)];
  if (stored) return finished(stored);
  if (held && environment.findLamps) return finished(environment.findLamps(options));
  return inWorker(environment, options, workers);
}

function finished(found: FoundLamps): LampSearch {
  return { take: () => found, dispose: () => {} };
}

function inWorker(environment: EnvironmentAsset, options: LampOptions, workers: WorkerService): LampSearch {
  let worker: NodeWorker | null = null;
  let answer: SearchAnswer | null = null;
  let isCanceled = false;
  const end = (result: SearchAnswer): void => {
    answer ??= result;
    worker?.dispose();
    worker = null;
  };
  const fail = (error: unknown): void => end({ failure: error instanceof Error ? error.message : String(error) });
  const search = (pixels: PanoramaPixels): void => {
    if (isCanceled) return;
    worker = workers.start({ onMessage: (data) => end(data as SearchAnswer), onFailure: (failure) => end({ failure }) });
    const message: SearchMessage = { pixels, options };
    worker.post(message, [pixels.data.buffer as ArrayBuffer]);
  };
  try {
    const pixels = environment.readPixels();
    if (pixels instanceof Promise) pixels.then(search).catch(fail);
    else search(pixels);
  } catch (error) {
    fail(error);
  }
  return {
    take: () => {
      if (answer && 'failure' in answer) throw new Error(answer.failure);
      return answer?.found ?? null;
    },
    dispose: () => {
      isCanceled = true;
      worker?.dispose();
      worker = null;
    },
  };
}
