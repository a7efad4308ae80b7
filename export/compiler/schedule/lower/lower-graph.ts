import { type FlatNode, portKey } from '../../flat-graph.ts';
import type { Demand } from '../demand.ts';
import { isDraw, layerOutput } from '../layers.ts';
import type { Leaf } from '../screen-plan.ts';
import { lowerCopyToScreen } from './lower-copy.ts';
import { isCpu, lowerCpu } from './lower-cpu.ts';
import { isDelayed, lowerCaptures, lowerDelayed } from './lower-delayed.ts';
import { isPlayed, lowerDraw, lowerNode, lowerParts } from './lower-node.ts';
import { type LoweredPasses, lowerLastPassAgain, lowerPasses } from './lower-passes.ts';
import { isTechnique, lowerTechnique } from './lower-technique.ts';
import type { Lowering } from './lowering.ts';

export interface Shown {
  /** Operations that draw to the screen, in painter's order. */
  readonly onScreen: readonly string[];
  /** Image nodes without a texture, because their last pass draws to the screen. */
  readonly ends: ReadonlyMap<string, LoweredPasses>;
}

/** Lowers everything that the output needs. `order` is topological, so inputs are lowered first. */
export function lowerShown(lowering: Lowering, order: readonly FlatNode[], leaves: readonly Leaf[], demand: Demand): Shown {
  const direct = new Set(leaves.flatMap((leaf) => (leaf.kind === 'texture' ? [] : [leaf.node.id])));
  const fusedDraws = new Set([...demand.fused.values()].map(({ id }) => id));
  const ends = new Map<string, LoweredPasses>();
  const drawnBy = new Map<string, string>();
  for (const node of order) {
    if (!demand.nodes.has(node.id)) continue;
    const fusedDraw = demand.fused.get(node.id);
    // The draw is lowered at the position of the occlusion, because the room depth may come after the objects.
    const isShown = needsTexture(node, demand) || (direct.has(node.id) && !fusedDraws.has(node.id));
    const draw = fusedDraw ?? (isDraw(node) && isShown ? node : null);
    lowerParts(lowering, node);
    if (isTechnique(node)) lowerTechnique(lowering, node);
    else if (isPlayed(node)) lowerNode(lowering, node);
    else if (isCpu(node)) lowerCpu(lowering, node);
    else if (isDelayed(node)) lowerDelayed(lowering, node);
    else if (draw) {
      const { id } = lowerDraw(lowering, {
        node: draw,
        occlusion: fusedDraw ? node : null,
        target: direct.has(node.id) ? 'screen' : 'texture',
        id: fusedDraw ? occludedId(node, fusedDraw, demand) : node.id,
      });
      drawnBy.set(node.id, id);
    } else if (node.definition.lowering.kind === 'image') {
      const lowered = lowerPasses(lowering, node, direct.has(node.id) ? 'screen' : 'texture');
      if (direct.has(node.id)) ends.set(node.id, lowered);
    }
  }
  lowerCaptures(lowering);
  return { onScreen: leaves.map((leaf, index) => lowerLeaf(lowering, leaf, index, ends, drawnBy)), ends };
}

/** Whether the layer of the node itself is needed as a texture. */
function needsTexture(node: FlatNode, { images }: Demand): boolean {
  const output = layerOutput(node);
  return output !== null && images.has(portKey(output));
}

/** Id of the operation that draws a node with its occlusion: the node's own id, unless it is drawn in other ways too. */
function occludedId(occlusion: FlatNode, draw: FlatNode, demand: Demand): string {
  const isAlone = [...demand.fused.values()].filter(({ id }) => id === draw.id).length === 1;
  return isAlone && !needsTexture(draw, demand) ? draw.id : occlusion.id;
}

/** Id of a draw that only a viewed layer needs. */
function viewedId(node: FlatNode): string {
  const output = layerOutput(node);
  return `${output ? portKey(output) : node.id}.tap`;
}

/**
 * Returns the id of the operation that draws a leaf; a texture gets a pass that copies it. The index of the leaf is part of the id of that
 * pass, because two leaves may show the same image.
 */
function lowerLeaf(lowering: Lowering, leaf: Leaf, index: number, ends: Shown['ends'], drawnBy: ReadonlyMap<string, string>): string {
  if (leaf.kind === 'draw') return drawnBy.get(leaf.node.id) ?? leaf.node.id;
  if (leaf.kind === 'passes') return `${leaf.node.id}.pass${(ends.get(leaf.node.id)?.passes.length ?? 1) - 1}`;
  const id = `${portKey(leaf.source)}.screen${index}`;
  lowerCopyToScreen(lowering, id, leaf.source, leaf.fit);
  return id;
}

/** Lowers viewed layers that the output does not need as textures. */
export function lowerViewed(lowering: Lowering, order: readonly FlatNode[], demand: Demand, { ends }: Shown): void {
  for (const node of order) {
    if (!demand.nodes.has(node.id)) continue;
    const fusedDraw = demand.fused.get(node.id);
    const ended = ends.get(node.id);
    lowerParts(lowering, node);
    if (isTechnique(node)) {
      lowerTechnique(lowering, node);
    } else if (isPlayed(node)) {
      if (!lowering.computedBy.has(node.id)) lowerNode(lowering, node);
    } else if (fusedDraw) lowerDraw(lowering, { node: fusedDraw, occlusion: node, target: 'texture', id: viewedId(node) });
    else if (!needsTexture(node, demand)) continue;
    else if (isCpu(node)) lowerCpu(lowering, node);
    else if (isDelayed(node)) lowerDelayed(lowering, node);
    else if (isDraw(node)) lowerDraw(lowering, { node, occlusion: null, target: 'texture', id: viewedId(node) });
    else if (ended) lowerLastPassAgain(lowering, node, ended);
    else lowerPasses(lowering, node, 'texture');
  }
  lowerCaptures(lowering);
}
