import { type FlatGraph, type FlatNode, portKey, type Source } from '../flat-graph.ts';
import { drawBehind } from './layers.ts';

/** What has to be there for some layers to be shown. */
export interface Demand {
  /** Nodes that have work to do. */
  readonly nodes: ReadonlySet<string>;
  /** Layers that have to be pictures, as `node.port`. */
  readonly images: ReadonlySet<string>;
  /** Occlusions that sink into the draw they hide a part of: occlusion → draw. */
  readonly sunk: ReadonlyMap<string, FlatNode>;
}

export interface DemandStart {
  readonly nodes: readonly string[];
  readonly images: readonly Source[];
  readonly sunk: readonly { readonly occlusion: FlatNode; readonly draw: FlatNode }[];
}

/** Walks from what is shown to where it comes from. `order` is topological; what is in `already` is not asked for again. */
export function findDemand(graph: FlatGraph, order: readonly FlatNode[], start: DemandStart, already: Demand | null = null): Demand {
  const nodes = new Set(start.nodes);
  const images = new Set<string>();
  const sunk = new Map<string, FlatNode>();
  const demandImage = (source: Source) => {
    if (already?.images.has(portKey(source))) return;
    images.add(portKey(source));
    nodes.add(source.node);
  };
  for (const source of start.images) demandImage(source);
  for (const { occlusion, draw } of start.sunk) {
    sunk.set(occlusion.id, draw);
    nodes.add(occlusion.id).add(draw.id);
  }
  const walked = new Set<string>();
  const walk = (node: FlatNode) => {
    walked.add(node.id);
    const draw = drawBehind(graph, node);
    if (draw && !sunk.has(node.id)) {
      sunk.set(node.id, draw);
      nodes.add(draw.id);
    }
    for (const [port, sources] of node.inputs) {
      const isLayer = node.definition.inputs[port]?.type === 'layer';
      if (isLayer && sunk.has(node.id)) continue;
      for (const source of sources) {
        if (isLayer) demandImage(source);
        else nodes.add(source.node);
      }
    }
  };
  // Against the order of the graph one round reaches all, but for what only delays ask for, which may stand behind them.
  for (let before = -1; before !== walked.size; ) {
    before = walked.size;
    for (let i = order.length - 1; i >= 0; i--) {
      const node = order[i];
      if (node && nodes.has(node.id) && !walked.has(node.id)) walk(node);
    }
  }
  return { nodes, images, sunk };
}
