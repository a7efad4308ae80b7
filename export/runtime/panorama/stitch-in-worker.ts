import type { PanoramaShot } from '../../../nodes/kit/panorama/shot.ts';
import type { StitchedPanorama } from '../../../nodes/kit/panorama/stitch.ts';
import type { StitchAnswer, StitchTask } from '../../../nodes/kit/panorama/stitch-protocol.ts';
import { type StartWorker, startBlobWorker } from '../cpu/worker-source.ts';

/** A panorama that is being stitched. */
export interface Stitching {
  /** Resolves to the panorama. Rejects with an `Error` whose message is text for the visitor. */
  readonly panorama: Promise<StitchedPanorama>;
  /** Stops the worker. The promise stays pending. */
  cancel(): void;
}

/**
 * Stitches photos in the worker of `source/panorama-capture`. The photos are copied, so that they can be used again.
 *
 * @param text The script of the worker.
 * @param onProgress Receives the progress, as a fraction in [0, 1].
 */
export function stitchInWorker(
  text: string,
  shots: readonly PanoramaShot[],
  widthPx: number,
  onProgress: (part: number) => void = () => {},
  start: StartWorker = startBlobWorker,
): Stitching {
  let stop = (): void => {};
  const panorama = new Promise<StitchedPanorama>((resolve, reject) => {
    const worker = start(text, {
      onMessage: (data) => {
        const answer = data as StitchAnswer;
        if (answer.kind === 'progress') return onProgress(answer.part);
        stop();
        if (answer.kind === 'done') resolve(answer.panorama);
        else reject(new Error(answer.reason));
      },
      onFailure: (reason) => {
        stop();
        reject(new Error(reason));
      },
    });
    stop = () => worker.dispose();
    const task: StitchTask = { shots, widthPx };
    worker.post(task, []);
  });
  return { panorama, cancel: () => stop() };
}
