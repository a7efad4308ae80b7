import type { Presentation } from '../../program/program.ts';
import { type FlatGraph, type FlatNode, portKey, type Source, sourcesAt } from '../flat-graph.ts';
import { type Fit, fitOf } from './layer-fit.ts';
import { drawBehind, isDraw, isWorld, type LayerTable, layerInputs, layerOutput } from './layers.ts';
import { readScreen } from './screen-options.ts';
import { movingBinding, startValue } from './slot-allocator.ts';

/** One thing laid onto the screen, over those before it. */
export type Leaf =
  /** Drawn straight into the session's framebuffer: `draw` is the node itself, or what this occlusion hides a part of. */
  | { readonly kind: 'draw'; readonly node: FlatNode; readonly draw: FlatNode }
  /** An image node whose last pass draws there. */
  | { readonly kind: 'passes'; readonly node: FlatNode }
  /** A picture that has to be there first, and is then copied. */
  | { readonly kind: 'picture'; readonly source: Source; readonly fit: Fit };

export interface ScreenPlan {
  /** In painter's order. */
  readonly leaves: readonly Leaf[];
  readonly background: Presentation['background'];
  /** Nodes that blending stands for. Their params are compiled in: another value is another plan. */
  readonly blended: ReadonlySet<string>;
}

/** The library's own: blending does the same, so that on the way to the screen its layers need not be pictures. */
const OVER_SHADER = 'operators/over.fs';

/**
 * Takes apart what the screen shows. A stack of `over` nodes is a list of layers, which can be laid over each other in the
 * session's framebuffer; whatever is drawn there directly needs no picture of its own, which saves a full-size target, its
 * resolve and its bandwidth (docs/ARCHITECTURE.md, “Drawing”). The world at the very bottom is the background and nothing to be drawn.
 */
export function planScreen(graph: FlatGraph, screen: FlatNode, layers: LayerTable, uses: ReadonlyMap<string, number>): ScreenPlan {
  const [shown] = layerInputs(screen);
  if (!shown) throw new Error('A screen without a layer has not been checked.');
  const leaves: Leaf[] = [];
  const blended = new Set<string>();
  const open: { readonly source: Source; readonly fit: Fit }[] = [{ source: shown, fit: fitOf(screen) }];
  for (let next = open.pop(); next; next = open.pop()) {
    const node = graph.nodes.get(next.source.node);
    const once = uses.get(portKey(next.source)) === 1;
    const over = node && once && layers.get(portKey(next.source))?.domain === 'view' ? layersOfOver(node) : null;
    if (node && over) {
      blended.add(node.id);
      open.push({ source: over.top, fit: fitOf(node) }, { source: over.bottom, fit: fitOf(node) });
    } else leaves.push((node && once && directLeaf(graph, node, layers)) || { kind: 'picture', ...next });
  }
  const [lowest] = leaves;
  const source = lowest?.kind === 'picture' ? graph.nodes.get(lowest.source.node) : undefined;
  if (source && isWorld(source)) return { leaves: leaves.slice(1), background: 'world', blended };
  return { leaves, background: readScreen(screen).background, blended };
}

/** An `over` that blending can take the place of: nothing set that blending does not do. */
function layersOfOver(node: FlatNode): { readonly top: Source; readonly bottom: Source } | null {
  if (!isOver(node)) return null;
  const [top] = sourcesAt(node, 'top');
  const [bottom] = sourcesAt(node, 'bottom');
  const plain = Object.entries(node.definition.params).every(
    ([name, param]) =>
      param.stage !== 'uniform' ||
      (!node.inputs.has(name) && !movingBinding(node, name) && startValue(node, name, param) === param.default),
  );
  return plain && top && bottom ? { top, bottom } : null;
}

/** What needs no picture on its way to the screen, if nobody else needs one of it. */
function directLeaf(graph: FlatGraph, node: FlatNode, layers: LayerTable): Leaf | null {
  if (isDraw(node)) return { kind: 'draw', node, draw: node };
  // A delayed picture has to be kept.
  if (node.definition.lowering.kind !== 'image' || node.definition.delay) return null;
  const draw = drawBehind(graph, node);
  if (draw) return { kind: 'draw', node, draw };
  const output = layerOutput(node);
  // A picture of its own size is drawn once for all views.
  return output && layers.get(portKey(output))?.domain === 'view' ? { kind: 'passes', node } : null;
}

function isOver({ definition: { lowering } }: FlatNode): boolean {
  return lowering.kind === 'image' && lowering.shader === OVER_SHADER;
}

/** How many wires each output has among `nodes`. */
export function countUses(nodes: Iterable<FlatNode>): ReadonlyMap<string, number> {
  const uses = new Map<string, number>();
  for (const node of nodes) {
    for (const sources of node.inputs.values()) {
      for (const source of sources) uses.set(portKey(source), (uses.get(portKey(source)) ?? 0) + 1);
    }
  }
  return uses;
}
