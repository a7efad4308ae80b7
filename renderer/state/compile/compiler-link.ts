import type { ShaderAbove } from '../../../export/compiler/compile.ts';
import type { ProjectLogic } from '../../../export/graph/project.ts';
import type { Program } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

export interface CompileRequest {
  readonly revision: number;
  readonly project: ProjectLogic;
  /** Layers that the program keeps for viewing; see `CompileOptions`. */
  readonly taps: readonly string[];
  readonly thumbnails: readonly string[];
}

export interface CompileAnswer {
  readonly revision: number;
  readonly program: Program | null;
  readonly diagnostics: readonly Diagnostic[];
  /** If there is no program: the shader texts above the mistakes, which a driver can still compile; see `Compiled`. */
  readonly above: readonly ShaderAbove[];
  readonly tookMs: number;
}

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

/**
 * Connects the editor to the compiler worker.
 *
 * @param onAnswer Called with each answer; `more` is true if a newer request has already started.
 */
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
