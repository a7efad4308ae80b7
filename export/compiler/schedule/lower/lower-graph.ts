import { type FlatNode, portKey } from '../../flat-graph.ts';
import type { Demand } from '../demand.ts';
import { isDraw, layerOutput } from '../layers.ts';
import type { Leaf } from '../screen-plan.ts';
import { lowerCopyToScreen } from './lower-copy.ts';
import { isCpu, lowerCpu } from './lower-cpu.ts';
import { isDelayed, lowerCaptures, lowerDelayed } from './lower-delayed.ts';
import { isPlayed, lowerDraw, lowerNode } from './lower-node.ts';
import { type LoweredPasses, lowerLastPassAgain, lowerPasses } from './lower-passes.ts';
import { isTechnique, lowerTechnique } from './lower-technique.ts';
import type { Lowering } from './lowering.ts';

export interface Shown {
  /** Operations that draw onto the screen, in painter's order. */
  readonly onScreen: readonly string[];
  /** Image nodes that have no picture, because they end on the screen. */
  readonly ends: ReadonlyMap<string, LoweredPasses>;
}

/** Everything that the screen needs. `order` is topological, so what a node reads is there before it. */
export function lowerShown(lowering: Lowering, order: readonly FlatNode[], leaves: readonly Leaf[], demand: Demand): Shown {
  const direct = new Set(leaves.flatMap((leaf) => (leaf.kind === 'picture' ? [] : [leaf.node.id])));
  const sinking = new Set([...demand.sunk.values()].map(({ id }) => id));
  const ends = new Map<string, LoweredPasses>();
  const drawnBy = new Map<string, string>();
  for (const node of order) {
    if (!demand.nodes.has(node.id)) continue;
    const sunkInto = demand.sunk.get(node.id);
    // Where the occlusion stands, because the room's depth may come after what it hides.
    const draw = sunkInto ?? (isDraw(node) && (!sinking.has(node.id) || isWanted(node, demand)) ? node : null);
    if (isTechnique(node)) lowerTechnique(lowering, node);
    else if (isPlayed(node)) lowerNode(lowering, node);
    else if (isCpu(node)) lowerCpu(lowering, node);
    else if (isDelayed(node)) lowerDelayed(lowering, node);
    else if (draw) {
      const { id } = lowerDraw(lowering, {
        node: draw,
        occlusion: sunkInto ? node : null,
        target: direct.has(node.id) ? 'screen' : 'picture',
        id: sunkInto ? idOfHidden(node, sunkInto, demand) : node.id,
      });
      drawnBy.set(node.id, id);
    } else if (node.definition.lowering.kind === 'image') {
      const lowered = lowerPasses(lowering, node, direct.has(node.id) ? 'screen' : 'picture');
      if (direct.has(node.id)) ends.set(node.id, lowered);
    }
  }
  lowerCaptures(lowering);
  return { onScreen: leaves.map((leaf, index) => lowerLeaf(lowering, leaf, index, ends, drawnBy)), ends };
}

/** Whether the layer of a node has to be a picture as it is. */
function isWanted(node: FlatNode, { images }: Demand): boolean {
  const output = layerOutput(node);
  return output !== null && images.has(portKey(output));
}

/** Of the operation that draws a node as its occlusion leaves it. It is the node's own, unless that is drawn in other ways too. */
function idOfHidden(occlusion: FlatNode, draw: FlatNode, demand: Demand): string {
  const isAlone = [...demand.sunk.values()].filter(({ id }) => id === draw.id).length === 1;
  return isAlone && !isWanted(draw, demand) ? draw.id : occlusion.id;
}

/** Of a draw besides the one that the screen needs. */
function tapId(node: FlatNode): string {
  const output = layerOutput(node);
  return `${output ? portKey(output) : node.id}.tap`;
}

/** The operation that draws the leaf. Its place among the leaves names a copy, because two may show the same picture. */
function lowerLeaf(lowering: Lowering, leaf: Leaf, index: number, ends: Shown['ends'], drawnBy: ReadonlyMap<string, string>): string {
  if (leaf.kind === 'draw') return drawnBy.get(leaf.node.id) ?? leaf.node.id;
  if (leaf.kind === 'passes') return `${leaf.node.id}.pass${(ends.get(leaf.node.id)?.passes.length ?? 1) - 1}`;
  const id = `${portKey(leaf.source)}.screen${index}`;
  lowerCopyToScreen(lowering, id, leaf.source, leaf.fit);
  return id;
}

/** What is looked at besides, where the screen has not needed it as a picture. */
export function lowerTapped(lowering: Lowering, order: readonly FlatNode[], demand: Demand, { ends }: Shown): void {
  for (const node of order) {
    if (!demand.nodes.has(node.id)) continue;
    const sunkInto = demand.sunk.get(node.id);
    const ended = ends.get(node.id);
    if (isTechnique(node)) {
      lowerTechnique(lowering, node);
    } else if (isPlayed(node)) {
      if (!lowering.computedBy.has(node.id)) lowerNode(lowering, node);
    } else if (sunkInto) lowerDraw(lowering, { node: sunkInto, occlusion: node, target: 'picture', id: tapId(node) });
    else if (!isWanted(node, demand)) continue;
    else if (isCpu(node)) lowerCpu(lowering, node);
    else if (isDelayed(node)) lowerDelayed(lowering, node);
    else if (isDraw(node)) lowerDraw(lowering, { node, occlusion: null, target: 'picture', id: tapId(node) });
    else if (ended) lowerLastPassAgain(lowering, node, ended);
    else lowerPasses(lowering, node, 'picture');
  }
  lowerCaptures(lowering);
}
