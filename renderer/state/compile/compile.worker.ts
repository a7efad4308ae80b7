import { createCompiler } from '../../../export/compiler/compile.ts';
import { DEFINITIONS, SHADERS } from '../../../nodes/generated/definitions.gen.ts';
import { workerClock } from '../../clock.ts';
import { createLibraries } from '../editor/library.ts';
import type { CompileAnswer, CompileRequest } from './compiler-link.ts';

/** Runs the compiler in a worker, because parsing a shader of 250 lines takes up to 200 ms. */
const scope = self as unknown as {
  onmessage: ((event: MessageEvent<CompileRequest>) => void) | null;
  postMessage(answer: CompileAnswer): void;
};
const compiler = createCompiler();
const libraries = createLibraries({ definitions: DEFINITIONS, shaders: SHADERS });

scope.onmessage = ({ data: { revision, project, taps, thumbnails, exported } }) => {
  const startMs = workerClock.nowMs();
  // While a header is broken, the node keeps its last valid interface. The diagnostics then report the header, not an unknown node
  // type.
  const library = libraries.withoutSubgraphs(project);
  // The loop budget ends endless loops, which would freeze the GPU that also draws the editor.
  const options = exported ? { fuse: true, fold: true } : { loopBudget: true, taps, thumbnails };
  const { output, diagnostics, above, separate, folded = [] } = compiler.compile({ project, library, options });
  scope.postMessage({ revision, program: output, diagnostics, above, separate, folded, tookMs: workerClock.nowMs() - startMs });
};
