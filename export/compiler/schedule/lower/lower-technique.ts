import type { Diagnostic } from '../../../../nodes/kit/diagnostics.ts';
import type { TechniqueShader } from '../../../glsl/technique/technique-shader.ts';
import type { DrawUnder } from '../../../program/program.ts';
import { type FlatNode, portKey, type Source, sourcesAt } from '../../flat-graph.ts';
import { addResource, type Lowering, resourceAt, type TechniqueReads, takeLink } from './lowering.ts';

/**
 * Adds the technique of `node` as a resource, shared by all its users. It needs no operation: the resource contains its text and the slots
 * of its values, for the operations that draw objects with it.
 */
export function lowerTechnique(lowering: Lowering, node: FlatNode): void {
  const { lowering: kind, inputs, outputs, params } = node.definition;
  if (kind.kind !== 'technique') throw new Error(`${node.id} is no technique.`);
  const port = Object.keys(outputs).find((name) => outputs[name]?.type === 'technique');
  const id = portKey({ node: node.id, port: port ?? '' });
  if (lowering.resourceOf.has(id)) return;
  const source = lowering.library.shader(kind.shader);
  if (source === undefined) throw new Error(`The library has no technique ${kind.shader}.`);
  const chunkOf = (name: string) => lowering.library.shader(`chunks/${name}.glsl`);
  const absent = Object.keys(inputs).filter((name) => !node.inputs.has(name));
  const options = { chunkOf, loopBudget: lowering.loopBudget, absent };
  const link = lowering.shaders.linkTechnique(kind.shader, source, options);
  const { output } = link;
  takeLink(lowering, node, link);
  lowering.resourceOf.set(id, id);
  if (output === null) return;
  // Every uniform param can be set at run time, even if the text does not use it.
  for (const [name, param] of Object.entries(params)) if (param.stage === 'uniform') lowering.slots.ofParam(node, name);
  const { technique, linked } = output;
  const samplers = linked.samplers.map(({ name, input }) => sampler(lowering, node, name, input, technique.pictures.includes(input)));
  const images = linked.pictures.flatMap(({ name, path }) => {
    const data = lowering.library.shader(path);
    if (data === undefined) lowering.diagnostics.push(missingImage(node, technique, path));
    return data === undefined ? [] : [{ name, data }];
  });
  lowering.techniqueReads.set(node.id, {
    layers: samplers.map(({ source }) => source.resource),
    readsBehind: linked.readsBehind,
    under: linked.readsBehind ? underOf(lowering, node) : null,
  });
  const unread = technique.unread.flatMap(({ name, input, values }) =>
    linked.uniforms.filter(({ param }) => param === input).map((uniform) => ({ name, uniform: uniform.name, values })),
  );
  addResource(lowering, {
    id,
    kind: 'technique',
    trial: lowering.trials.push({ shader: linked.trial, node: node.id }) - 1,
    vertex: linked.vertex,
    fragment: linked.fragment,
    passes: technique.passes,
    uniforms: linked.uniforms.map(({ name, type, param }) => ({ name, type, slot: lowering.slots.ofParam(node, param) })),
    ...(samplers.length > 0 ? { samplers } : {}),
    ...(unread.length > 0 ? { unread } : {}),
    ...(images.length > 0 ? { pictures: images } : {}),
  });
}

function missingImage({ id }: FlatNode, { file, imported }: TechniqueShader, path: string): Diagnostic {
  const { line = 1, column = 1 } = imported.find((one) => one.path === path) ?? {};
  return {
    code: 'SCR043',
    severity: 'error',
    nodeId: id,
    file,
    line,
    column,
    message: `The image “${path}” is not in the library.`,
    fix: 'Replace its IMPORTED entry with an input of TYPE "image" and connect an image.',
  };
}

/**
 * The sampler of a layer that a technique reads; the layer is drawn before the objects. A layer in the image domain is fitted to the view,
 * unless the technique reads it by UV (`isPicture`).
 */
function sampler(lowering: Lowering, node: FlatNode, name: string, input: string, isPicture: boolean) {
  const [layer] = sourcesAt(node, input);
  if (!layer) throw new Error(`The technique ${node.id} reads ${input}, which has no wire.`);
  const isImage = lowering.layers.get(portKey(layer))?.domain === 'image';
  return {
    name,
    source: { kind: 'color', resource: resourceAt(lowering, layer) },
    fit: isImage && !isPicture ? 'cover' : 'none',
  } as const;
}

/** The input of a technique for the layer behind its objects, which the library's glass has. */
const BEHIND_INPUT = 'behind';

/** The layer at a technique's input `BEHIND_INPUT`; null if none is connected. */
function underOf(lowering: Lowering, node: FlatNode): DrawUnder | null {
  const [source] = sourcesAt(node, BEHIND_INPUT);
  return source ? underAt(lowering, source) : null;
}

/** Describes a layer that glass shows where there are no objects. */
export function underAt(lowering: Lowering, source: Source): DrawUnder {
  const { domain, encoding = 'display' } = lowering.layers.get(portKey(source)) ?? {};
  return { resource: resourceAt(lowering, source), fit: domain === 'image' ? 'cover' : 'none', encoding };
}

/**
 * What the techniques of a draw's objects read. The techniques are found by following the inputs of the draw and of the nodes before it,
 * except layers.
 */
export function readsOfTechniques({ graph, techniqueReads }: Lowering, draw: FlatNode): TechniqueReads[] {
  const reads: TechniqueReads[] = [];
  const behind = new Set([draw]);
  // The set grows during the iteration.
  for (const node of behind) {
    const own = techniqueReads.get(node.id);
    if (own) reads.push(own);
    if (own) continue;
    for (const [port, sources] of node.inputs) {
      if (node.definition.inputs[port]?.type === 'layer') continue;
      for (const { node: id } of sources) {
        const before = graph.nodes.get(id);
        if (before) behind.add(before);
      }
    }
  }
  return reads;
}

export function isTechnique({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'technique';
}
