import type { CpuAnswer, CpuTask } from '../../../nodes/kit/cpu-filter.ts';

/** A worker that answers every task. */
export interface CpuWorker {
  /** Takes the task's buffer away until its answer. */
  post(task: CpuTask): void;
  dispose(): void;
}

export interface CpuListener {
  onAnswer(answer: CpuAnswer): void;
  /** It will not answer any more. */
  onFailure(message: string): void;
}

/** Starts a worker from its text; injected, so that a test sees one fail. Throws where the browser gives none. */
export type StartWorker = (text: string, listener: CpuListener) => CpuWorker;

/** From a blob, because pages opened from a disk get no worker from a file (`worker-src blob:` in the page's policy). */
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
