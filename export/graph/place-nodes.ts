import { own } from './own.ts';
import type { Graph, GraphLayout, NodeLayout } from './project.ts';
import { topologicalOrder } from './topology.ts';

const COLUMN_PX = 280;
const ROW_PX = 180;

/**
 * A place for every node of a graph: the one in the layout, and for nodes that have none a column by how many nodes lie between
 * them and the graph's sources, below what stands there. Canvas units.
 */
export function placeNodes(graph: Graph, layout: GraphLayout | undefined): Readonly<Record<string, NodeLayout>> {
  const columns = columnsOf(graph);
  const places: Record<string, NodeLayout> = {};
  const placed = Object.keys(graph.nodes).flatMap((id) => {
    const place = layout && own(layout.nodes, id);
    if (place) places[id] = place;
    return place ? [place] : [];
  });
  const top = placed.length === 0 ? 0 : Math.max(...placed.map(({ y }) => y)) + ROW_PX;
  const left = placed.length === 0 ? 0 : Math.min(...placed.map(({ x }) => x));
  const rows = new Map<number, number>();
  for (const id of Object.keys(graph.nodes).sort()) {
    if (own(places, id)) continue;
    const column = columns.get(id) ?? 0;
    const row = rows.get(column) ?? 0;
    rows.set(column, row + 1);
    places[id] = { x: left + column * COLUMN_PX, y: top + row * ROW_PX };
  }
  return places;
}

/** Nodes on loops, which cannot be ordered, go first. */
function columnsOf(graph: Graph): Map<string, number> {
  const followers = new Map<string, string[]>(Object.keys(graph.nodes).map((id) => [id, []]));
  for (const { from, to } of graph.wires) if (followers.has(to.node)) followers.get(from.node)?.push(to.node);
  const columns = new Map<string, number>();
  for (const id of topologicalOrder(followers.keys(), (node) => followers.get(node) ?? []).order) {
    const column = columns.get(id) ?? 0;
    for (const next of followers.get(id) ?? []) columns.set(next, Math.max(columns.get(next) ?? 0, column + 1));
  }
  return columns;
}
