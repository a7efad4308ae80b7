import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import { type StartWorker, startBlobWorker } from '../../cpu/worker-source.ts';
import { PanoramaError, type RadianceHeader } from './radiance-header.ts';
import type { RadianceAnswer, RadianceTask } from './radiance-worker.ts';
import type { HalfPixels, ReadRadiance } from './read-radiance.ts';

/**
 * Decodes Radiance HDR and OpenEXR beside the page, so that its frames go on. Each file has a worker of its own, because its memory is freed
 * only with the worker.
 *
 * @param text The text of the worker: `nodes/generated/workers/decode-radiance.gen.ts`.
 */
export function readRadianceInWorker(text: string, start: StartWorker = startBlobWorker): ReadRadiance {
  const decode = (as: RadianceTask['as'], bytes: ArrayBuffer, header: RadianceHeader): Promise<PanoramaPixels> =>
    new Promise((resolve, reject) => {
      const fail = (reason: string): void => reject(new PanoramaError(reason));
      const worker = start(text, {
        onMessage: (data) => {
          const answer = data as RadianceAnswer;
          worker.dispose();
          if ('failure' in answer) fail(answer.failure);
          else resolve(answer.pixels);
        },
        onFailure: (reason) => {
          worker.dispose();
          fail(`its decoder failed: ${reason}. Reload the page, or use a smaller panorama`);
        },
      });
      // The bytes are copied: the file may be read again.
      const task: RadianceTask = { as, bytes, header };
      worker.post(task, []);
    });
  return {
    halves: (bytes, header) => decode('halves', bytes, header) as Promise<HalfPixels>,
    floats: (bytes, header) => decode('floats', bytes, header),
  };
}
