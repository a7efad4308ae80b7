import type { CompileAnswer, CompileRequest } from './messages.ts';

/** The used part of `Worker`, so that tests can substitute it. */
export interface CompilerWorker {
  postMessage(message: CompileRequest): void;
  onmessage: ((event: MessageEvent<CompileAnswer>) => void) | null;
  terminate(): void;
}

export interface CompilerLink {
  /** Compiles a project. If the compiler is busy, only the newest request is kept. */
  request(request: CompileRequest): void;
  dispose(): void;
}

/** @param onAnswer Called with each answer; `more` is true if a newer request has already started. */
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
