import type { LayerDepthRef } from '../../../program/program.ts';
import { type FlatNode, portKey, type Source } from '../../flat-graph.ts';
import { layerInputs } from '../layers.ts';
import { addResource, addStep, type Lowering, nodeAt, valueSteps } from './lowering.ts';
import { passSamplers, passUniforms, shaderOf, sizeOf } from './pass-parts.ts';

/**
 * The depth of a layer, or null if it has none. A computed depth, as of `over`, gets its pass at the first request, because most are never
 * read.
 */
export function depthAt(lowering: Lowering, layer: Source): LayerDepthRef | null {
  const origin = originOf(lowering, layer);
  if (origin === null || origin.kind === 'drawn') return origin?.depth ?? null;
  const key = portKey(origin.layer);
  if (!lowering.computedDepth.has(key)) {
    for (const missing of missingDepths(lowering, origin.layer)) lowerComputedDepth(lowering, missing);
  }
  return lowering.computedDepth.get(key) ?? null;
}

type DepthOrigin =
  | { readonly kind: 'drawn'; readonly depth: LayerDepthRef }
  /** Depth that an image node computes from its inputs. */
  | { readonly kind: 'computed'; readonly layer: Source };

function originOf({ layers, graph, drawn, resourceOf }: Lowering, layer: Source): DepthOrigin | null {
  let at = layers.get(portKey(layer))?.depth ?? null;
  while (at) {
    const key = portKey(at);
    const resource = resourceOf.get(key);
    if (resource !== undefined && drawn.has(key)) return { kind: 'drawn', depth: { resource, encoding: 'window' } };
    const node = graph.nodes.get(at.node);
    if (node?.definition.lowering.kind !== 'image') return null;
    if (node.definition.outputs[at.port]?.depth === true) return { kind: 'computed', layer: at };
    // An occlusion that is not fused passes on the depth of its input.
    const [hidden] = layerInputs(node);
    at = hidden ? (layers.get(portKey(hidden))?.depth ?? null) : null;
  }
  return null;
}

/**
 * Layers whose depths must be computed for the depth of `layer`, each after those that it depends on. No recursion, because stacks of
 * `over` can be deep.
 */
function missingDepths(lowering: Lowering, layer: Source): Source[] {
  const missing = new Map([[portKey(layer), layer]]);
  // The map grows during the iteration.
  for (const { node } of missing.values()) {
    for (const input of layerInputs(nodeAt(lowering, node))) {
      const origin = originOf(lowering, input);
      if (origin?.kind === 'computed' && !lowering.computedDepth.has(portKey(origin.layer)))
        missing.set(portKey(origin.layer), origin.layer);
    }
  }
  const rankOf = ({ node }: Source) => lowering.rank.get(node) ?? 0;
  return [...missing.values()].sort((a, b) => rankOf(a) - rankOf(b));
}

function lowerComputedDepth(lowering: Lowering, layer: Source): void {
  const node = nodeAt(lowering, layer.node);
  const resource = addResource(lowering, {
    id: `${portKey(layer)}.depth`,
    kind: 'target',
    domain: lowering.layers.get(portKey(layer))?.domain ?? 'view',
    size: sizeOf(lowering, node, null, null),
    format: 'r32f',
    depth: 'none',
    samples: 1,
    lifetime: 'frame',
  });
  lowering.computedDepth.set(portKey(layer), { resource, encoding: 'meters' });
  lowering.writerOf.set(resource, resource);
  const { file, source, variant } = shaderOf(lowering, node, (input) => depthAt(lowering, input) !== null);
  const pass = lowering.shaders.linkDepth(file, source, variant);
  const samplers = passSamplers(lowering, node, pass, new Map(), (input) => depthAt(lowering, input));
  addStep(
    lowering,
    {
      id: resource,
      node: node.id,
      kind: 'pass',
      view: lowering.layers.get(portKey(layer))?.domain === 'image' ? 'once' : 'each',
      reads: samplers.reads,
      writes: [resource],
      shader: pass.shader,
      parts: pass.parts,
      target: resource,
      blend: 'replace',
      samplers: samplers.samplers,
      uniforms: passUniforms(lowering, node, pass),
      passIndex: pass.passIndex,
      access: 'pointwise',
    },
    valueSteps(lowering, node),
  );
}

/** Whether the layer at a port of the node has depth, for shaders that test it. */
export function hasDepth(lowering: Lowering, node: FlatNode, port: string): boolean {
  const [source] = node.inputs.get(port) ?? [];
  return source !== undefined && originOf(lowering, source) !== null;
}
