import ELK from 'elkjs/lib/elk.bundled.js';
import type { Place } from '../editor/canvas-state.ts';

/** Position and size of a node or reroute, in canvas units. */
export interface NodeBox extends Place {
  readonly id: string;
  readonly width: number;
  readonly height: number;
}

/** Layers from left to right. Distances are multiples of the canvas grid of 8. */
const OPTIONS = {
  'elk.algorithm': 'layered',
  'elk.direction': 'RIGHT',
  'elk.layered.spacing.nodeNodeBetweenLayers': '80',
  'elk.spacing.nodeNode': '32',
  'elk.spacing.componentComponent': '64',
  'elk.layered.nodePlacement.strategy': 'NETWORK_SIMPLEX',
};
const GRID = 8;

/**
 * Computes new positions of boxes; their top left corner stays.
 *
 * @param joined Wires between boxes, as pairs of ids. Wires to other boxes are ignored.
 */
export async function layOut(
  boxes: readonly NodeBox[],
  joined: readonly (readonly [from: string, to: string])[],
): Promise<ReadonlyMap<string, Place>> {
  const ids = new Set(boxes.map(({ id }) => id));
  const edges = joined
    .filter(([from, to]) => ids.has(from) && ids.has(to))
    .map(([from, to], index) => ({ id: String(index), sources: [from], targets: [to] }));
  const children = boxes.map(({ id, width, height, x, y }) => ({ id, width, height, x, y }));
  const { children: placed = [] } = await new ELK().layout({ id: 'graph', layoutOptions: OPTIONS, children, edges });
  const corner = (of: 'x' | 'y', list: readonly { readonly x?: number; readonly y?: number }[]) =>
    Math.min(...list.map((box) => box[of] ?? 0));
  const by = { x: corner('x', boxes) - corner('x', placed), y: corner('y', boxes) - corner('y', placed) };
  const onGrid = (value: number) => Math.round(value / GRID) * GRID;
  return new Map(placed.map(({ id, x = 0, y = 0 }) => [id, { x: onGrid(x + by.x), y: onGrid(y + by.y) }]));
}
