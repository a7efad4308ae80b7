import { createCompiler } from '../../../export/compiler/compile.ts';
import { DEFINITIONS, SHADERS } from '../../../nodes/generated/definitions.gen.ts';
import { workerClock } from '../../clock.ts';
import { createLibraries } from '../editor/library.ts';
import type { CompileAnswer, CompileRequest } from './messages.ts';

/** The compiler, off the page's thread: parsing a shader of 250 lines takes up to 200 ms. */
const scope = self as unknown as {
  onmessage: ((event: MessageEvent<CompileRequest>) => void) | null;
  postMessage(answer: CompileAnswer): void;
};
const compiler = createCompiler();
const libraries = createLibraries({ definitions: DEFINITIONS, shaders: SHADERS });

scope.onmessage = ({ data: { revision, project, taps } }) => {
  const startMs = workerClock.nowMs();
  // A type whose header is broken at the moment is the one it was: its header's mistake is said, not that nothing is known of it.
  const library = libraries.withoutSubgraphs(project);
  // No loop may hold up the GPU that the editor itself is drawn with.
  const { output, diagnostics, above } = compiler.compile({ project, library, options: { loopBudget: true, taps } });
  scope.postMessage({ revision, program: output, diagnostics, above, tookMs: workerClock.nowMs() - startMs });
};
