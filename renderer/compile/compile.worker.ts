import { validateProject } from '../../export/graph/validate/validate.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { createLibraries } from '../state/library.ts';
import type { CompileAnswer, CompileRequest } from './messages.ts';

const libraries = createLibraries({ definitions: DEFINITIONS, shaders: SHADERS });
const scope = self as unknown as {
  onmessage: ((event: MessageEvent<CompileRequest>) => void) | null;
  postMessage(answer: CompileAnswer): void;
};
scope.onmessage = ({ data: { revision, project } }) => {
  const diagnostics = validateProject(project, libraries.of(project));
  scope.postMessage({ revision, program: null, diagnostics, tookMs: 1 });
};
