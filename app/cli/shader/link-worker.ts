import { parentPort } from 'node:worker_threads';
import { linkFile } from './link-file.ts';

/** What `create-linker.ts` sends. */
export interface LinkQuestion {
  readonly source: string;
  readonly file: string;
  readonly vertex: string | null;
}

parentPort?.postMessage({ ready: true });

/** A file that is too much for the linker brings an answer as well: the worker stays for the next. */
parentPort?.on('message', ({ source, file, vertex }: LinkQuestion) => {
  try {
    parentPort?.postMessage({ linked: linkFile(source, file, vertex) });
  } catch (error) {
    parentPort?.postMessage({ fault: error instanceof Error ? (error.stack ?? error.message) : String(error) });
  }
});
