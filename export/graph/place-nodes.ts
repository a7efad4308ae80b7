import type { Graph, GraphLayout, NodeLayout } from './project.ts';
import { getOwn } from './record.ts';
import { topologicalOrder } from './topology.ts';

const COLUMN_PX = 280;
const ROW_PX = 180;

/**
 * Positions of all nodes of a graph: from the layout, or else in columns by the distance from the sources of the graph, below the placed
 * nodes.
 *
 * @returns Positions by node id, canvas units.
 *
 * @example
 * // A camera, connected to a sepia filter.
 * placeNodes(graph, undefined); // { 'sepia-k7q2': { x: 280, y: 0 }, 'video-a1b2': { x: 0, y: 0 } }
 */
export function placeNodes(graph: Graph, layout: GraphLayout | undefined): Readonly<Record<string, NodeLayout>> {
  const columns = columnsOf(graph);
  const places: Record<string, NodeLayout> = {};
  const placed = Object.keys(graph.nodes).flatMap((id) => {
    const place = layout && getOwn(layout.nodes, id);
    if (place) places[id] = place;
    return place ? [place] : [];
  });
  const top = placed.length === 0 ? 0 : Math.max(...placed.map(({ y }) => y)) + ROW_PX;
  const left = placed.length === 0 ? 0 : Math.min(...placed.map(({ x }) => x));
  const rows = new Map<number, number>();
  for (const id of Object.keys(graph.nodes).sort()) {
    if (getOwn(places, id)) continue;
    const column = columns.get(id) ?? 0;
    const row = rows.get(column) ?? 0;
    rows.set(column, row + 1);
    places[id] = { x: left + column * COLUMN_PX, y: top + row * ROW_PX };
  }
  return places;
}

/** Columns by the longest path from a source, without wires that close loops. */
function columnsOf(graph: Graph): Map<string, number> {
  const followers = new Map<string, string[]>(Object.keys(graph.nodes).map((id) => [id, []]));
  for (const { from, to } of graph.wires) if (followers.has(to.node)) followers.get(from.node)?.push(to.node);
  openLoops(followers);
  const columns = new Map<string, number>();
  for (const id of topologicalOrder(followers.keys(), (node) => followers.get(node) ?? []).order) {
    const column = columns.get(id) ?? 0;
    for (const next of followers.get(id) ?? []) columns.set(next, Math.max(columns.get(next) ?? 0, column + 1));
  }
  return columns;
}

/** Removes the wires that lead back to an ancestor of a depth-first search, so that each loop starts where it is entered. */
function openLoops(followers: Map<string, string[]>): void {
  const { left } = topologicalOrder(followers.keys(), (node) => followers.get(node) ?? []);
  if (left.size === 0) return;
  const entered = [...followers].filter(([id]) => !left.has(id)).flatMap(([, next]) => next.filter((id) => left.has(id)));
  const walked = new Set<string>();
  for (const start of [...entered, ...[...left].sort()]) {
    // Iterative, because a loop may have ten thousand nodes.
    const way: { readonly id: string; readonly next: readonly string[]; at: number }[] = [];
    const onWay = new Set<string>();
    const enter = (id: string): void => {
      walked.add(id);
      onWay.add(id);
      const next = (followers.get(id) ?? []).filter((follower) => !onWay.has(follower));
      followers.set(id, next);
      way.push({ id, next, at: 0 });
    };
    if (!walked.has(start)) enter(start);
    for (let here = way.at(-1); here; here = way.at(-1)) {
      const follower = here.next[here.at++];
      if (follower === undefined) {
        onWay.delete(here.id);
        way.pop();
      } else if (!walked.has(follower)) enter(follower);
    }
  }
}
