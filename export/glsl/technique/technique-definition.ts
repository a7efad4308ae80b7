import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import { paramsOf, portsOf, titleFrom } from '../isf/isf-definition.ts';
import type { TechniqueShader } from './technique-shader.ts';

/** Creates the node type of a technique: `gooch` gives `technique/gooch`. */
export function techniqueDefinition(technique: TechniqueShader, name: string): NodeDefinition {
  const title = technique.title ?? titleFrom(name);
  return {
    type: `technique/${name}`,
    version: technique.renamed.length + 1,
    title,
    doc: technique.description || `${title}, a technique.`,
    ...(technique.categories.length > 0 ? { keywords: technique.categories.map((category) => category.toLowerCase()) } : {}),
    inputs: portsOf(technique.inputs),
    outputs: { technique: { type: 'technique', label: 'Material', doc: 'The material to draw objects with, for “Set material”.' } },
    params: paramsOf(technique.inputs),
    lowering: { kind: 'technique', shader: technique.file },
    ...(technique.renamed.length === 0 ? {} : { renamed: technique.renamed }),
    ...(technique.credit === '' ? {} : { credit: technique.credit }),
    ...(technique.licence === '' ? {} : { licence: technique.licence }),
  };
}
