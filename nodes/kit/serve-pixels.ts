import type { CpuAnswer, CpuTask, Pixels } from './cpu-filter.ts';

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: CpuTask }) => void) | null;
  postMessage(answer: CpuAnswer, transfer: ArrayBuffer[]): void;
}

/**
 * Runs a CPU filter in a worker: for each message, processes the image in the message's buffer and answers with the same buffer.
 *
 * @param scope The global scope of the worker.
 * @param process Changes the image in place. An error that it throws is returned with the answer.
 *
 * @example
 * servePixels(self, process);
 */
export function servePixels(scope: WorkerScope, process: (pixels: Pixels, params: never) => void): void {
  scope.onmessage = ({ data: { view, turn, buffer, widthPx, heightPx, params } }) => {
    let failure: string | null = null;
    try {
      process({ data: new Uint8Array(buffer), widthPx, heightPx }, params as never);
    } catch (error) {
      failure = error instanceof Error ? error.message : String(error);
    }
    scope.postMessage({ view, turn, buffer, failure }, [buffer]);
  };
}
