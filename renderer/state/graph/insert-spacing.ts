import type { Graph } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Stretch } from '../../../export/graph/routes.ts';
import type { Place } from '../editor/canvas-state.ts';
import { type DocumentState, graphOf, layoutOf } from '../editor/document.ts';
import { NODE_WIDTH } from './node-shape.ts';

const GAP = 40;
/** Grid of the canvas, in canvas units. */
const GRID = 8;
/** Vertical distance above which nodes do not overlap, or only slightly. */
const BESIDE = 100;

/**
 * New positions for a node that is inserted into a wire, as in Blender: to the right of the source, and the target and all nodes
 * after it move right as far as needed. Reroutes stay.
 */
export function placesAfterInsert(state: DocumentState, node: string, { x, y }: Place, at: Stretch): Readonly<Record<string, Place>> {
  const places = layoutOf(state).nodes;
  const isBeside = (other: Place) => Math.abs(other.y - y) < BESIDE;
  const source = getOwn(places, at.source.node);
  const behind = at.before.length === 0 && source && isBeside(source) && source.x <= x ? source.x + NODE_WIDTH + GAP : x;
  const left = Math.max(x, behind);
  const moved: Record<string, Place> = { [node]: { x: left, y } };
  const [{ to }] = at.wires;
  const target = at.to === null ? getOwn(places, to.node) : undefined;
  if (!target || !isBeside(target) || (source && target.x <= source.x)) return moved;
  const by = Math.ceil((left + NODE_WIDTH + GAP - target.x) / GRID) * GRID;
  if (by <= 0) return moved;
  for (const id of nodesAfter(graphOf(state), to.node)) {
    const place = getOwn(places, id);
    if (id !== node && place && place.x >= target.x) moved[id] = { x: place.x + by, y: place.y };
  }
  return moved;
}

/** A node and all nodes that its wires lead to. */
function nodesAfter({ wires }: Graph, first: string): ReadonlySet<string> {
  const found = new Set([first]);
  // The loop also visits nodes that are added during it.
  for (const node of found) for (const { from, to } of wires) if (from.node === node) found.add(to.node);
  return found;
}
