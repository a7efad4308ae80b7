import type { LayerDomain, LayerEncoding } from '../../../nodes/kit/definition.ts';
import { type EncodedNode, outputEncoding } from '../../graph/layer-encoding.ts';
import { boundValue } from '../../graph/library/param-value.ts';
import { type FlatGraph, type FlatNode, portKey, type Source, sourcesAt } from '../flat-graph.ts';

/** Static properties of a layer. */
export interface LayerInfo {
  readonly domain: LayerDomain;
  readonly encoding: LayerEncoding;
  /**
   * Source of its depth: the nearest layer towards its origin that has or may get its own depth. Null if there is none, or if pixels were
   * moved since.
   */
  readonly depth: Source | null;
}

export type LayerTable = ReadonlyMap<string, LayerInfo>;

/** Computes the properties of all layers. `order` is topological. */
export function describeLayers(order: Iterable<FlatNode>): LayerTable {
  const layers = new Map<string, LayerInfo>();
  for (const node of order) {
    for (const [port, output] of Object.entries(node.definition.outputs)) {
      if (output.type !== 'layer') continue;
      const source = { node: node.id, port };
      layers.set(portKey(source), {
        domain: domainOf(node, port, layers),
        encoding: outputEncoding(
          encodedNode(node, (input) => layers.get(portKey(input))?.encoding ?? 'display'),
          port,
        ),
        depth: depthOf(node, source, layers),
      });
    }
  }
  return layers;
}

/** Layers connected to a node, in the order of its ports. */
export function layerInputs(node: FlatNode): Source[] {
  return Object.entries(node.definition.inputs).flatMap(([port, { type }]) => (type === 'layer' ? sourcesAt(node, port) : []));
}

export function layerOutput({ definition, id }: FlatNode): Source | null {
  const port = Object.keys(definition.outputs).find((name) => definition.outputs[name]?.type === 'layer');
  return port === undefined ? null : { node: id, port };
}

/** Whether the node draws objects: a geometry node with a layer output. */
export function isDraw(node: FlatNode): boolean {
  return node.definition.lowering.kind === 'geometry' && layerOutput(node) !== null;
}

/** Whether the node draws its layer by its own GL program. */
export function drawsItself({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'geometry' && definition.lowering.ownDrawing !== undefined;
}

/** Whether the node draws by blending alone: with smooth edges, and without a depth buffer on the screen. */
export function onlyBlends({ definition: { lowering } }: FlatNode): boolean {
  return lowering.kind === 'geometry' && lowering.ownDrawing?.blends === true;
}

/** Whether the node can apply an occlusion while it draws. */
function hidesBehindRoom({ definition: { lowering } }: FlatNode): boolean {
  return lowering.kind === 'geometry' && (lowering.ownDrawing === undefined || lowering.ownDrawing.hidesBehindRoom === true);
}

export function isWorld({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'source' && definition.lowering.background === 'world';
}

/** Whether the node is an occlusion that can be applied while its layer is drawn. */
export function isEarlyOcclusion({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'image' && definition.lowering.early === 'occlusion';
}

/** The draw that the occlusion can be fused with, or null. */
export function drawBehind(graph: FlatGraph, occlusion: FlatNode): FlatNode | null {
  if (!isEarlyOcclusion(occlusion)) return null;
  const [source] = layerInputs(occlusion);
  const node = source && graph.nodes.get(source.node);
  return node && isDraw(node) && hidesBehindRoom(node) ? node : null;
}

/** The domain of an output. It is `view` if the room or a view-aligned layer contributes. */
function domainOf(node: FlatNode, port: string, layers: LayerTable): LayerDomain {
  const { domain = 'same' } = node.definition.outputs[port] ?? {};
  if (domain !== 'same') return domain;
  const meetsRoom = Object.entries(node.definition.inputs).some(([name, { type }]) => type === 'depth' && node.inputs.has(name));
  const inputs = layerInputs(node);
  if (meetsRoom || inputs.length === 0) return 'view';
  return inputs.every((source) => layers.get(portKey(source))?.domain === 'image') ? 'image' : 'view';
}

function depthOf(node: FlatNode, output: Source, layers: LayerTable): Source | null {
  const { lowering, outputs } = node.definition;
  const { depth = false } = outputs[output.port] ?? {};
  // An occlusion that is fused with a draw has the depth of the visible fragments.
  if (depth === true || isEarlyOcclusion(node)) return output;
  if (depth === false) return null;
  // A displaced or resized layer loses its depth.
  if (lowering.kind === 'image' && (lowering.access === 'displaced' || lowering.access === 'resize')) return null;
  const [first] = layerInputs(node);
  return first ? (layers.get(portKey(first))?.depth ?? null) : null;
}

/** A node of the flat graph, for the rules of `export/graph/layer-encoding.ts`. */
export function encodedNode(node: FlatNode, encodingOf: (source: Source) => LayerEncoding): EncodedNode {
  return {
    definition: node.definition,
    paramValue: (name) => {
      const binding = node.bindings.get(name);
      return (binding && boundValue(binding)) ?? node.definition.params[name]?.default;
    },
    encodingAt: (port) => {
      const [source] = sourcesAt(node, port);
      return source ? encodingOf(source) : null;
    },
  };
}
