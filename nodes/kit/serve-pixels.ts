import type { CpuAnswer, CpuTask, Pixels } from './cpu-filter.ts';

/** The worker's own scope, as far as it is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: CpuTask }) => void) | null;
  postMessage(answer: CpuAnswer, transfer: ArrayBuffer[]): void;
}

/** What a worker does that plays a CPU filter: one picture after the other, each in the buffer that it came in. */
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
