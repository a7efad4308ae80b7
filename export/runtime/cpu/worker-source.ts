import type { NodeWorker, WorkerListener } from '../../../nodes/kit/runtime.ts';

/** Starts a worker from its text. It is injected, so that tests can simulate failures. Throws if the browser does not start it. */
export type StartWorker = (text: string, listener: WorkerListener) => NodeWorker;

/** Starts a worker from a blob, because pages opened from a disk cannot start one from a file (`worker-src blob:` in the page's policy). */
export const startBlobWorker: StartWorker = (text, { onMessage, onFailure }) => {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  const worker = new Worker(url);
  worker.onmessage = ({ data }: MessageEvent<unknown>) => onMessage(data);
  worker.onmessageerror = () => onFailure('its answer could not be read');
  worker.onerror = (event) => {
    event.preventDefault();
    onFailure(event.message || 'the browser did not start it');
  };
  return {
    post: (message, transfer) => worker.postMessage(message, transfer as ArrayBuffer[]),
    dispose: () => {
      worker.terminate();
      URL.revokeObjectURL(url);
    },
  };
};
