import { parentPort } from 'node:worker_threads';
import { linkFile } from './link-file.ts';

/** Message that `create-linker.ts` sends to the worker: a file to link. */
export interface LinkQuestion {
  readonly source: string;
  readonly file: string;
  readonly vertex: string | null;
}

parentPort?.postMessage({ ready: true });

/** Links the file of a message. Always answers, even if the linker throws, so that the worker stays usable. */
parentPort?.on('message', ({ source, file, vertex }: LinkQuestion) => {
  try {
    parentPort?.postMessage({ linked: linkFile(source, file, vertex) });
  } catch (error) {
    parentPort?.postMessage({ fault: error instanceof Error ? (error.stack ?? error.message) : String(error) });
  }
});
