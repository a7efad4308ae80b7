import type { CpuAnswer, CpuTask } from '../../../nodes/kit/cpu-filter.ts';

/** A worker that answers every task. */
export interface CpuWorker {
  /** Sends a task and transfers its buffer until the answer. */
  post(task: CpuTask): void;
  dispose(): void;
}

export interface CpuListener {
  onAnswer(answer: CpuAnswer): void;
  /** The worker will not answer any more. */
  onFailure(message: string): void;
}

/** Starts a worker from its text. It is injected, so that tests can simulate failures. Throws if the browser does not start it. */
export type StartWorker = (text: string, listener: CpuListener) => CpuWorker;

/** Starts a worker from a blob, because pages opened from a disk cannot start one from a file (`worker-src blob:` in the page's policy). */
export const startBlobWorker: StartWorker = (text, { onAnswer, onFailure }) => {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  const worker = new Worker(url);
  worker.onmessage = ({ data }: MessageEvent<CpuAnswer>) => onAnswer(data);
  worker.onmessageerror = () => onFailure('its answer could not be read');
  worker.onerror = (event) => {
    event.preventDefault();
    onFailure(event.message || 'the browser did not start it');
  };
  const transfer: ArrayBuffer[] = [];
  return {
    post: (task) => {
      transfer[0] = task.buffer;
      worker.postMessage(task, transfer);
    },
    dispose: () => {
      worker.terminate();
      URL.revokeObjectURL(url);
    },
  };
};
