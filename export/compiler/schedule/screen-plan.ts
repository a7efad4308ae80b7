import type { Presentation } from '../../program/program-presentation.ts';
import { type FlatGraph, type FlatNode, portKey, type Source, sourcesAt } from '../flat-graph.ts';
import { drawBehind, isDraw, isWorld, type LayerTable, layerInputs, layerOutput } from './layers.ts';
import { type Fit, fitOf } from './lower/pass-parts.ts';
import { readScreen } from './screen-options.ts';
import { movingBinding, startValue } from './slot-allocator.ts';

/** One layer that is drawn to the screen, over the previous ones. */
export type Leaf =
  /** Drawn to the session's framebuffer directly. `draw` is the node itself, or the draw that this occlusion is fused with. */
  | { readonly kind: 'draw'; readonly node: FlatNode; readonly draw: FlatNode }
  /** An image node whose last pass draws to the screen. */
  | { readonly kind: 'passes'; readonly node: FlatNode }
  /** A texture that is drawn first and then copied. */
  | { readonly kind: 'texture'; readonly source: Source; readonly fit: Fit };

export interface ScreenPlan {
  /** In painter's order. */
  readonly leaves: readonly Leaf[];
  readonly background: Presentation['background'];
  /** Nodes that blending replaces. Their params are compiled in, because other values give another plan. */
  readonly blended: ReadonlySet<string>;
}

/** The shader of the library's `over`, which blending can replace. */
const OVER_SHADER = 'operators/over.fs';

/**
 * Splits the content of the screen into leaves. A stack of `over` nodes becomes a list of layers that are blended in the session's
 * framebuffer; a layer that is drawn there directly needs no texture, which saves a full-size target, its resolve and its bandwidth
 * (docs/ARCHITECTURE.md, “Drawing”). The camera image at the very bottom is the background and needs no operation.
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
    } else leaves.push((node && once && directLeaf(graph, node, layers)) || { kind: 'texture', ...next });
  }
  const [lowest] = leaves;
  const source = lowest?.kind === 'texture' ? graph.nodes.get(lowest.source.node) : undefined;
  if (source && isWorld(source)) return { leaves: leaves.slice(1), background: 'world', blended };
  return { leaves, background: readScreen(screen).background, blended };
}

/** The two layers of an `over` that blending can replace, because all its uniform params have their default values; else null. */
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

/** The leaf for a node that can draw to the screen directly if nothing else needs its texture; else null. */
function directLeaf(graph: FlatGraph, node: FlatNode, layers: LayerTable): Leaf | null {
  if (isDraw(node)) return { kind: 'draw', node, draw: node };
  // The result of a delayed node must be kept.
  if (node.definition.lowering.kind !== 'image' || node.definition.delay) return null;
  const draw = drawBehind(graph, node);
  if (draw) return { kind: 'draw', node, draw };
  const output = layerOutput(node);
  // An image of its own size is drawn once for all views.
  return output && layers.get(portKey(output))?.domain === 'view' ? { kind: 'passes', node } : null;
}

function isOver({ definition: { lowering } }: FlatNode): boolean {
  return lowering.kind === 'image' && lowering.shader === OVER_SHADER;
}

/** Counts the wires from each output to `nodes`. */
export function countUses(nodes: Iterable<FlatNode>): ReadonlyMap<string, number> {
  const uses = new Map<string, number>();
  for (const node of nodes) {
    for (const sources of node.inputs.values()) {
      for (const source of sources) uses.set(portKey(source), (uses.get(portKey(source)) ?? 0) + 1);
    }
  }
  return uses;
}
