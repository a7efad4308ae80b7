import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Result } from '../../nodes/kit/diagnostics.ts';
import { isfDefinition, shaderName } from './isf/isf-definition.ts';
import type { IsfShader } from './isf/isf-shader.ts';
import { readIsf } from './isf/read-isf.ts';
import { readTechnique } from './technique/read-technique.ts';
import { techniqueDefinition } from './technique/technique-definition.ts';
import { isTechnique } from './technique/technique-shader.ts';
import { isTransition } from './transition/is-transition.ts';
import { readTransition } from './transition/read-transition.ts';

/** The node type that a shader file is: an ISF file, or by its ending and content a technique or a transition. */
export function readDefinition(source: string, file: string): Result<NodeDefinition> {
  if (isTechnique(source, file)) {
    const { output, diagnostics } = readTechnique(source, file);
    return { output: output && techniqueDefinition(output, shaderName(file)), diagnostics };
  }
  const { output, diagnostics } = readImageShader(source, file);
  return { output: output && isfDefinition(output, shaderName(file)), diagnostics };
}

/** An ISF file, with the vertex shader beside it where it has one (`companionOf`), or a transition. */
export function readImageShader(source: string, file: string, vertex: string | null = null): Result<IsfShader> {
  return isTransition(source, file) ? readTransition(source, file) : readIsf(source, file, vertex);
}
