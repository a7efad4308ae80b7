import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import { isfDefinition, shaderName } from './isf/isf-definition.ts';
import type { IsfShader } from './isf/isf-shader.ts';
import { readIsf } from './isf/read-isf.ts';
import { parseShader } from './syntax/parse.ts';
import { GlslError } from './syntax/token.ts';
import { readTechnique } from './technique/read-technique.ts';
import { techniqueDefinition } from './technique/technique-definition.ts';
import { isTechnique } from './technique/technique-shader.ts';
import { isTransition } from './transition/is-transition.ts';
import { readTransition } from './transition/read-transition.ts';

/** Reads the node type of a shader file: an ISF shader, or a technique or transition by its extension and content. */
export function readDefinition(source: string, file: string): Result<NodeDefinition> {
  if (isTechnique(source, file)) {
    const { output, diagnostics } = readTechnique(source, file);
    return { output: output && techniqueDefinition(output, shaderName(file)), diagnostics };
  }
  const { output, diagnostics } = readImageShader(source, file);
  return { output: output && isfDefinition(output, shaderName(file)), diagnostics };
}

/** Reads ports and params from the header alone. The GLSL is not parsed, so the shader counts as one that reads neighbors of each pixel. */
export function readNodeInterface(source: string, file: string): Result<NodeDefinition> {
  if (isTechnique(source, file)) return readDefinition(source, file);
  const { output, diagnostics } = readImageShader(source, file);
  return { output: output && isfDefinition(output, shaderName(file), 'neighborhood'), diagnostics };
}

/** Syntax errors of the GLSL below an invalid header. */
function syntaxErrors(source: string, file: string, told: readonly Diagnostic[]): Diagnostic[] {
  try {
    parseShader(source);
    return [];
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    const { code, message, place } = error;
    return told.some(({ line }) => line === place.line) ? [] : [{ code, severity: 'error', message, file, ...place }];
  }
}

/** Reads an ISF file with its vertex shader, if any (`companionOf`), or a transition. */
export function readImageShader(source: string, file: string, vertex: string | null = null): Result<IsfShader> {
  if (isTransition(source, file)) return readTransition(source, file);
  const { output, diagnostics } = readIsf(source, file, vertex);
  return { output, diagnostics: output === null ? [...diagnostics, ...syntaxErrors(source, file, diagnostics)] : diagnostics };
}
