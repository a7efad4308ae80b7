import { cpus } from 'node:os';
import { Worker } from 'node:worker_threads';
import { bundleWorker } from '../bundle-worker.ts';
import type { PhotoAnswer, PhotoResults, PhotoTask } from './photo-task.ts';

/** Worker threads that decode, draw and encode photographs. They start with the first task. */
export interface PhotoWorkers {
  /** Number of tasks that run at a time. */
  readonly count: number;
  /** Rejects with an `Error` whose message is the end of a sentence about the photograph. */
  run<K extends PhotoTask['kind']>(task: PhotoTask & { readonly kind: K }): Promise<PhotoResults[K]>;
  /** Ends all threads. Tasks that run are rejected. */
  dispose(): Promise<void>;
}

const MOST_WORKERS = 3;
/** Photographs that are decoded at a time have at most so many pixels together: two of 12 megapixels take 1.1 GB with all else. */
const MOST_PIXELS = 30e6;

/**
 * @param root Absolute path of the folder with Scrim's sources and `node_modules`.
 * @param largestPx Number of pixels of the largest photograph: of large ones, fewer are decoded at a time.
 */
export function createPhotoWorkers(root: string, largestPx: number): PhotoWorkers {
  const count = Math.max(1, Math.min(Math.floor(MOST_PIXELS / largestPx), MOST_WORKERS, cpus().length));
  const all = new Set<Worker>();
  const idle: Worker[] = [];
  const waiting: (() => void)[] = [];
  let script: Promise<string> | null = null;
  let busy = 0;
  let isDisposed = false;
  const take = async (): Promise<Worker> => {
    if (busy >= count) await new Promise<void>((go) => waiting.push(go));
    busy++;
    try {
      script ??= bundleWorker(root, 'export/bundle/photos/photo-worker.ts');
      const code = await script;
      if (isDisposed) throw new Error(ENDED);
      return idle.pop() ?? start(code);
    } catch (error) {
      release();
      throw error;
    }
  };
  const start = (code: string): Worker => {
    const worker = new Worker(code, { eval: true, workerData: root, stdout: true, stderr: true });
    all.add(worker);
    // An error between two tasks has no task to reject.
    worker.on('error', () => {
      all.delete(worker);
      if (idle.includes(worker)) idle.splice(idle.indexOf(worker), 1);
    });
    return worker;
  };
  const release = (): void => {
    busy--;
    waiting.shift()?.();
  };
  return {
    count,
    run: async <K extends PhotoTask['kind']>(task: PhotoTask & { readonly kind: K }) => {
      const worker = await take();
      let answer: PhotoAnswer;
      try {
        answer = await ask(worker, task);
        idle.push(worker);
      } catch (error) {
        // It may have run out of memory.
        all.delete(worker);
        void worker.terminate();
        throw error;
      } finally {
        release();
      }
      if (!answer.ok) throw new Error(answer.reason);
      return answer.result as PhotoResults[K];
    },
    dispose: async () => {
      isDisposed = true;
      await Promise.all([...all].map((worker) => worker.terminate()));
    },
  };
}

const ENDED = 'was not finished';

function ask(worker: Worker, task: PhotoTask): Promise<PhotoAnswer> {
  return new Promise((resolve, reject) => {
    const end = (settle: () => void) => {
      worker.off('message', onMessage).off('error', onError).off('exit', onExit);
      worker.unref();
      settle();
    };
    const onMessage = (answer: PhotoAnswer) => end(() => resolve(answer));
    const onError = (error: unknown) => end(() => reject(error instanceof Error ? error : new Error(String(error))));
    const onExit = () => end(() => reject(new Error(ENDED)));
    worker.on('message', onMessage).on('error', onError).on('exit', onExit);
    worker.ref();
    worker.postMessage(task);
  });
}
