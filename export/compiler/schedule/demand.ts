import { actorsOf, type FlatGraph, type FlatNode, portKey, type Source } from '../flat-graph.ts';
import { drawBehind } from './layers.ts';

/** What must be computed to show some layers. */
export interface Demand {
  /** Nodes that need an operation. */
  readonly nodes: ReadonlySet<string>;
  /** Layers that must be textures, as `node.port`. */
  readonly images: ReadonlySet<string>;
  /** Occlusions that are fused with the draw whose objects they hide: occlusion → draw. */
  readonly fused: ReadonlyMap<string, FlatNode>;
}

export interface DemandStart {
  readonly nodes: readonly string[];
  readonly images: readonly Source[];
  readonly fused: readonly { readonly occlusion: FlatNode; readonly draw: FlatNode }[];
}

/** Walks from the shown layers to their sources. `order` is topological; images in `already` are not demanded again. */
export function findDemand(graph: FlatGraph, order: readonly FlatNode[], start: DemandStart, already: Demand | null = null): Demand {
  const nodes = new Set(start.nodes);
  const images = new Set<string>();
  const fused = new Map<string, FlatNode>();
  const demandImage = (source: Source) => {
    if (already?.images.has(portKey(source))) return;
    images.add(portKey(source));
    nodes.add(source.node);
  };
  for (const source of start.images) demandImage(source);
  for (const { occlusion, draw } of start.fused) {
    fused.set(occlusion.id, draw);
    nodes.add(occlusion.id).add(draw.id);
  }
  const actors = actorsOf(order);
  const walked = new Set<string>();
  const walk = (node: FlatNode) => {
    walked.add(node.id);
    for (const actor of actors.get(node.id) ?? []) nodes.add(actor);
    const draw = drawBehind(graph, node);
    if (draw && !fused.has(node.id)) {
      fused.set(node.id, draw);
      nodes.add(draw.id);
    }
    for (const [port, sources] of node.inputs) {
      const isLayer = node.definition.inputs[port]?.type === 'layer';
      if (isLayer && fused.has(node.id)) continue;
      for (const source of sources) {
        if (isLayer) demandImage(source);
        else nodes.add(source.node);
      }
    }
  };
  // In reverse graph order one pass finds all, except what only delays demand, which may come later.
  for (let before = -1; before !== walked.size; ) {
    before = walked.size;
    for (let i = order.length - 1; i >= 0; i--) {
      const node = order[i];
      if (node && nodes.has(node.id) && !walked.has(node.id)) walk(node);
    }
  }
  return { nodes, images, fused };
}
