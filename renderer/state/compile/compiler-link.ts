import type { ShaderAbove } from '../../../export/compiler/compile.ts';
import type { FoldedNode } from '../../../export/compiler/fold/folded-node.ts';
import type { SeparateWire } from '../../../export/compiler/schedule/fuse/separate-wire.ts';
import type { ProjectLogic } from '../../../export/graph/project.ts';
import type { Program } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

export interface CompileRequest {
  /** Revision of the document; negative for candidates. */
  readonly revision: number;
  readonly project: ProjectLogic;
  /** Layers that the program keeps for viewing; see `CompileOptions`. */
  readonly taps: readonly string[];
  readonly thumbnails: readonly string[];
  /** Compiles as for an exported page, without viewed layers. Default: false. */
  readonly exported?: true;
}

export interface CompileAnswer {
  readonly revision: number;
  readonly program: Program | null;
  readonly diagnostics: readonly Diagnostic[];
  /** If there is no program: the shader texts above the mistakes, which a driver can still compile; see `Compiled`. */
  readonly above: readonly ShaderAbove[];
  /** Wires between passes that are not fused; see `Compiled`. */
  readonly separate?: readonly SeparateWire[];
  /** Nodes that are left out; see `Compiled`. */
  readonly folded?: readonly FoldedNode[];
  readonly tookMs: number;
}

/** The used part of `Worker`, so that tests can substitute it. */
export interface CompilerWorker {
  postMessage(message: CompileRequest): void;
  onmessage: ((event: MessageEvent<CompileAnswer>) => void) | null;
  terminate(): void;
}

export interface CompilerLink {
  /** Compiles a project. If the compiler is busy, only the newest request is kept, and the newest for a candidate, which waits longer. */
  request(request: CompileRequest): void;
  dispose(): void;
}

/**
 * Connects the editor to the compiler worker.
 *
 * @param onAnswer Called with each answer; `more` is true if a newer request of the document has already started.
 */
export function createCompilerLink(worker: CompilerWorker, onAnswer: (answer: CompileAnswer, more: boolean) => void): CompilerLink {
  let running = false;
  let waiting: CompileRequest | null = null;
  let waitingCandidate: CompileRequest | null = null;
  const start = (request: CompileRequest) => {
    running = true;
    worker.postMessage(request);
  };
  worker.onmessage = ({ data }) => {
    running = false;
    const more = waiting !== null;
    const next = waiting ?? waitingCandidate;
    if (more) waiting = null;
    else waitingCandidate = null;
    if (next !== null) start(next);
    onAnswer(data, more);
  };
  return {
    request: (request) => {
      if (!running) start(request);
      else if (request.revision < 0) waitingCandidate = request;
      else waiting = request;
    },
    dispose: () => {
      worker.onmessage = null;
      worker.terminate();
    },
  };
}
