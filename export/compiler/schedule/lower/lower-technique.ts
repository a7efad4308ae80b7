import { type FlatNode, portKey } from '../../flat-graph.ts';
import { addResource, type Lowering } from './lowering.ts';

/** Once for each node, whoever asks. A technique is no work by itself: its text and where its values are, for those who draw objects with it. */
export function lowerTechnique(lowering: Lowering, node: FlatNode): void {
  const { lowering: kind, outputs, params } = node.definition;
  if (kind.kind !== 'technique') throw new Error(`${node.id} is no technique.`);
  const port = Object.keys(outputs).find((name) => outputs[name]?.type === 'technique');
  const id = portKey({ node: node.id, port: port ?? '' });
  if (lowering.resourceOf.has(id)) return;
  const source = lowering.library.shader(kind.shader);
  if (source === undefined) throw new Error(`The library has no technique ${kind.shader}.`);
  const chunkOf = (name: string) => lowering.library.shader(`chunks/${name}.glsl`);
  const options = { chunkOf, loopBudget: lowering.loopBudget };
  const { output, diagnostics } = lowering.shaders.linkTechnique(kind.shader, source, options);
  lowering.diagnostics.push(...diagnostics.map((diagnostic) => ({ ...diagnostic, nodeId: node.id })));
  lowering.resourceOf.set(id, id);
  if (output === null) return;
  // Every uniform param can be set while running, whether the text uses it or not.
  for (const [name, param] of Object.entries(params)) if (param.stage === 'uniform') lowering.slots.ofParam(node, name);
  const { technique, linked } = output;
  addResource(lowering, {
    id,
    kind: 'technique',
    trial: lowering.trials.push({ shader: linked.trial, node: node.id }) - 1,
    vertex: linked.vertex,
    fragment: linked.fragment,
    passes: technique.passes,
    uniforms: linked.uniforms.map(({ name, type, param }) => ({ name, type, slot: lowering.slots.ofParam(node, param) })),
  });
}

export function isTechnique({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'technique';
}
