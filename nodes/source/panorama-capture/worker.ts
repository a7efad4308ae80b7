import { stitch } from '../../kit/panorama/stitch.ts';
import type { StitchAnswer, StitchTask } from '../../kit/panorama/stitch-protocol.ts';

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: StitchTask }) => void) | null;
  postMessage(answer: StitchAnswer, transfer: ArrayBuffer[]): void;
}

/** Stitches photos in a worker, so that the page continues to draw frames. */
export function serve(scope: WorkerScope): void {
  scope.onmessage = ({ data: { shots, widthPx } }) => {
    try {
      const slices = stitch(shots, widthPx);
      for (let step = 0; ; step++) {
        const { done, value } = slices.next();
        if (done) return scope.postMessage({ kind: 'done', panorama: value }, [value.data.buffer]);
        // A slice is 16 rows.
        scope.postMessage({ kind: 'progress', part: Math.min(1, (step * 16) / (widthPx / 2)) }, []);
      }
    } catch (error) {
      scope.postMessage({ kind: 'failed', reason: error instanceof Error ? error.message : String(error) }, []);
    }
  };
}
