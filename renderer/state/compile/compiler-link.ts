import type { CompileAnswer, CompileRequest } from './messages.ts';

/** The part of `Worker` that is used, so that a test can stand in for it. */
export interface CompilerWorker {
  postMessage(message: CompileRequest): void;
  onmessage: ((event: MessageEvent<CompileAnswer>) => void) | null;
  terminate(): void;
}

export interface CompilerLink {
  /** The newest request is answered; of those that wait, older ones are dropped. */
  request(request: CompileRequest): void;
  dispose(): void;
}

/** `more` tells that a newer request has been started already. */
export function createCompilerLink(worker: CompilerWorker, onAnswer: (answer: CompileAnswer, more: boolean) => void): CompilerLink {
  let running = false;
  let waiting: CompileRequest | null = null;
  const start = (request: CompileRequest) => {
    running = true;
    worker.postMessage(request);
  };
  worker.onmessage = ({ data }) => {
    running = false;
    const next = waiting;
    waiting = null;
    if (next !== null) start(next);
    onAnswer(data, next !== null);
  };
  return {
    request: (request) => {
      if (running) waiting = request;
      else start(request);
    },
    dispose: () => {
      worker.onmessage = null;
      worker.terminate();
    },
  };
}
