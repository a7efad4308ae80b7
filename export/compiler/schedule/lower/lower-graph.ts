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
  for (const node of order) {
    if (!demand.nodes.has(node.id)) continue;
    const sunkInto = demand.sunk.get(node.id);
    // Where the occlusion stands, because the room's depth may come after what it hides.
    const draw = sunkInto ?? (isDraw(node) && !sinking.has(node.id) ? node : null);
    if (isTechnique(node)) lowerTechnique(lowering, node);
    else if (isPlayed(node)) lowerNode(lowering, node);
    else if (isCpu(node)) lowerCpu(lowering, node);
    else if (isDelayed(node)) lowerDelayed(lowering, node);
    else if (draw) {
      lowerDraw(lowering, {
        node: draw,
        occlusion: sunkInto ? node : null,
        target: direct.has(draw.id) ? 'screen' : 'picture',
        extra: false,
      });
    } else if (node.definition.lowering.kind === 'image') {
      const lowered = lowerPasses(lowering, node, direct.has(node.id) ? 'screen' : 'picture');
      if (direct.has(node.id)) ends.set(node.id, lowered);
    }
  }
  lowerCaptures(lowering);
  return { onScreen: leaves.map((leaf, index) => lowerLeaf(lowering, leaf, index, ends)), ends };
}

/** The operation that draws the leaf. Its place among the leaves names a copy, because two may show the same picture. */
function lowerLeaf(lowering: Lowering, leaf: Leaf, index: number, ends: Shown['ends']): string {
  if (leaf.kind === 'draw') return leaf.node.id;
  if (leaf.kind === 'passes') return `${leaf.node.id}.pass${(ends.get(leaf.node.id)?.passes.length ?? 1) - 1}`;
  const id = `${portKey(leaf.source)}.screen${index}`;
  lowerCopyToScreen(lowering, id, leaf.source, leaf.fit);
  return id;
}

/** What is looked at besides, where the screen has not needed it as a picture. */
export function lowerTapped(lowering: Lowering, order: readonly FlatNode[], demand: Demand, { ends }: Shown): void {
  for (const node of order) {
    if (!demand.nodes.has(node.id)) continue;
    const output = layerOutput(node);
    const isPicture = output !== null && demand.images.has(portKey(output));
    const sunkInto = demand.sunk.get(node.id);
    const ended = ends.get(node.id);
    if (isTechnique(node)) {
      lowerTechnique(lowering, node);
    } else if (isPlayed(node)) {
      if (!lowering.computedBy.has(node.id)) lowerNode(lowering, node);
    } else if (sunkInto) lowerDraw(lowering, { node: sunkInto, occlusion: node, target: 'picture', extra: true });
    else if (!isPicture) continue;
    else if (isCpu(node)) lowerCpu(lowering, node);
    else if (isDelayed(node)) lowerDelayed(lowering, node);
    else if (isDraw(node)) lowerDraw(lowering, { node, occlusion: null, target: 'picture', extra: true });
    else if (ended) lowerLastPassAgain(lowering, node, ended);
    else lowerPasses(lowering, node, 'picture');
  }
  lowerCaptures(lowering);
}
