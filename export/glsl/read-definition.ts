import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Result } from '../../nodes/kit/diagnostics.ts';
import { isfDefinition, shaderName } from './isf/isf-definition.ts';
import { readIsf } from './isf/read-isf.ts';
import { readTechnique } from './technique/read-technique.ts';
import { techniqueDefinition } from './technique/technique-definition.ts';
import { isTechniqueFile } from './technique/technique-shader.ts';

/** The node type that a shader file is: an ISF file, or a technique by its ending. */
export function readDefinition(source: string, file: string): Result<NodeDefinition> {
  if (isTechniqueFile(file)) {
    const { output, diagnostics } = readTechnique(source, file);
    return { output: output && techniqueDefinition(output, shaderName(file)), diagnostics };
  }
  const { output, diagnostics } = readIsf(source, file);
  return { output: output && isfDefinition(output, shaderName(file)), diagnostics };
}
