import { createCompiler } from '../../export/compiler/compile.ts';
import type { CompileAnswer, CompileRequest, CompilerWorker } from '../../renderer/state/compile/compiler-link.ts';
import { LIBRARY } from './library.ts';

/** The real compiler, which answers when it is told to. */
export function createSlowCompiler() {
  const compiler = createCompiler();
  const waiting: CompileRequest[] = [];
  const worker: CompilerWorker = { postMessage: (request) => void waiting.push(request), onmessage: null, terminate: () => {} };
  const answer = () => {
    const request = waiting.shift();
    if (!request) throw new Error('Nothing was asked.');
    const { output, diagnostics, above } = compiler.compile({ project: request.project, library: LIBRARY });
    const data: CompileAnswer = { revision: request.revision, program: output, diagnostics, above, tookMs: 1 };
    worker.onmessage?.({ data } as MessageEvent<CompileAnswer>);
  };
  return { worker, waiting, answer };
}
