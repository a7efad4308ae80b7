import type { LayerDomain } from '../../../nodes/kit/definition.ts';
import { type FlatGraph, type FlatNode, portKey, type Source, sourcesAt } from '../flat-graph.ts';

/** What is known of a layer before anything is drawn. */
export interface LayerInfo {
  readonly domain: LayerDomain;
  /**
   * Where its depth comes from: the nearest layer on the way to its origin that has a depth of its own making, or may get one.
   * Null where there is none, or where pixels have been moved since.
   */
  readonly depth: Source | null;
}

export type LayerTable = ReadonlyMap<string, LayerInfo>;

/** Over the nodes in topological order. */
export function describeLayers(order: Iterable<FlatNode>): LayerTable {
  const layers = new Map<string, LayerInfo>();
  for (const node of order) {
    for (const [port, output] of Object.entries(node.definition.outputs)) {
      if (output.type !== 'layer') continue;
      const source = { node: node.id, port };
      layers.set(portKey(source), { domain: domainOf(node, port, layers), depth: depthOf(node, source, layers) });
    }
  }
  return layers;
}

/** Layers wired to a node, in the order of its ports. */
export function layerInputs(node: FlatNode): Source[] {
  return Object.entries(node.definition.inputs).flatMap(([port, { type }]) => (type === 'layer' ? sourcesAt(node, port) : []));
}

export function layerOutput({ definition, id }: FlatNode): Source | null {
  const port = Object.keys(definition.outputs).find((name) => definition.outputs[name]?.type === 'layer');
  return port === undefined ? null : { node: id, port };
}

/** Draws objects: a geometry node that gives a layer. */
export function isDraw(node: FlatNode): boolean {
  return node.definition.lowering.kind === 'geometry' && layerOutput(node) !== null;
}

export function isWorld({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'source' && definition.lowering.background === 'world';
}

/** Hides what is behind the room, and can do so while its layer is drawn. */
export function isEarlyOcclusion({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'image' && definition.lowering.early === 'occlusion';
}

/** The draw whose fragments an occlusion could discard itself, if what it hides is drawn at all. */
export function drawBehind(graph: FlatGraph, occlusion: FlatNode): FlatNode | null {
  if (!isEarlyOcclusion(occlusion)) return null;
  const [source] = layerInputs(occlusion);
  const node = source && graph.nodes.get(source.node);
  return node && isDraw(node) ? node : null;
}

/** Whatever meets the room or a view-aligned layer is view-aligned from there on. */
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
  // An occlusion that sinks into a draw gets the depth of what is left of it.
  if (depth === true || isEarlyOcclusion(node)) return output;
  if (depth === false) return null;
  // A displaced or resized layer loses its depth.
  if (lowering.kind === 'image' && (lowering.access === 'displaced' || lowering.access === 'resize')) return null;
  const [first] = layerInputs(node);
  return first ? (layers.get(portKey(first))?.depth ?? null) : null;
}
