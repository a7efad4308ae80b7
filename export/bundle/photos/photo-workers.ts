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

/** Each takes some 400 MB for a photograph of 12 megapixels. */
const MOST_WORKERS = 3;

/**
 * @param root Absolute path of the folder with Scrim's sources and `node_modules`.
 * @param most The most threads.
 */
export function createPhotoWorkers(root: string, most = MOST_WORKERS): PhotoWorkers {
  const count = Math.max(1, Math.min(most, MOST_WORKERS, cpus().length));
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
      const worker = idle.pop() ?? new Worker(code, { eval: true, workerData: root, stdout: true, stderr: true });
      all.add(worker);
      return worker;
    } catch (error) {
      release();
      throw error;
    }
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
