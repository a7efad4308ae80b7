import type { IsfShader } from '../../glsl/isf/isf-shader.ts';
import { sameValue } from '../../graph/library/param-value.ts';
import { type FlatNode, portKey, type Source } from '../flat-graph.ts';
import { type LayerTable, layerInputs, layerOutput } from '../schedule/layers.ts';
import { constantParam } from './constants.ts';

/** What must be known of layers and shaders to find effects that change nothing. */
export interface UnchangedLayers {
  readonly layers: LayerTable;
  node(id: string): FlatNode | undefined;
  /** The shader of an image node; null for other nodes. */
  shaderOf(node: FlatNode): IsfShader | null;
  /** Whether the shader is one of the project, of which an `IDENTITY` may be wrong. */
  isOfProject(node: FlatNode): boolean;
}

/**
 * The layer that an effect only repeats, because each param for which its header names an identity has that value; null if it may change
 * something. The layer is the first one, or the lower one of two that are put over each other.
 *
 * The effect is kept if the layer differs in more than its pixels: in depth, domain or encoding; and if a color of the layer may exceed its
 * alpha, as of added light, because an effect of straight colors clamps it. A layer of the camera is kept, too, where
 * another effect reads it, because its pixels are not those of the view: the effect rounds between them and the reader.
 */
export function unchangedLayer(
  node: FlatNode,
  readers: readonly FlatNode[],
  { layers, node: nodeOf, shaderOf, isOfProject }: UnchangedLayers,
): Source | null {
  const { lowering, params, visitorParams, delay } = node.definition;
  const output = layerOutput(node);
  if (lowering.kind !== 'image' || visitorParams || delay || output === null) return null;
  const shader = isOfProject(node) ? null : shaderOf(node);
  const identities = shader?.inputs.filter(({ identity }) => identity !== null) ?? [];
  if (shader === null || identities.length === 0) return null;
  const isIdentity = identities.every(({ name, identity }) => {
    const param = params[name];
    const value = param && constantParam(node, name, param);
    return value !== undefined && identity !== null && sameValue(typeof value === 'object' ? value : [Number(value)], identity);
  });
  if (!isIdentity) return null;
  const inputs = layerInputs(node);
  const isOver = shader.depth === 'over';
  const layer = isOver ? inputs[1] : inputs[0];
  const before = layer && layers.get(portKey(layer));
  const after = layers.get(portKey(output));
  if (!layer || !before || !after || before.domain !== after.domain || before.encoding !== after.encoding) return null;
  // The depth of two layers is that of the lower one where the upper one is transparent.
  if (!isOver && depthKey(before.depth) !== depthKey(after.depth)) return null;
  if (isOver && before.domain === 'image') return null;
  const producer = nodeOf(layer.node);
  const isSource = producer?.definition.lowering.kind === 'source';
  const isInAlpha = isSource || (producer !== undefined && shaderOf(producer)?.premultiplied === false);
  if (!shader.premultiplied && !isInAlpha) return null;
  const isShown = readers.every(({ definition }) => definition.lowering.kind === 'present');
  return isSource && before.domain === 'view' && !isShown ? null : layer;
}

function depthKey(depth: Source | null): string {
  return depth === null ? '' : portKey(depth);
}
