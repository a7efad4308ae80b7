import type { Graph } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Stretch } from '../../../export/graph/routes.ts';
import type { Place } from '../editor/canvas-state.ts';
import { type DocumentState, graphOf, layoutOf } from '../editor/document.ts';
import { NODE_WIDTH } from './node-shape.ts';

const GAP = 40;
/** The grid that nodes snap to. */
const GRID = 8;
/** Nodes whose heads are further apart do not hide each other, or hardly. */
const BESIDE = 100;

/**
 * Where nodes go when one is let go over a wire, as in Blender: it stands clear of the node that the wire comes from, and what the wire
 * leads to goes to the right as far as it must, with all that comes after it there. Reroutes stay: they say where a wire is to run.
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

/** The nodes that wires lead to from one, this included. */
function nodesAfter({ wires }: Graph, first: string): ReadonlySet<string> {
  const found = new Set([first]);
  // The set grows while it is walked.
  for (const node of found) for (const { from, to } of wires) if (from.node === node) found.add(to.node);
  return found;
}
