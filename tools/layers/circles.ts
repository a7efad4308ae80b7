/** An import graph: the names that each name imports. */
export type Graph = ReadonlyMap<string, ReadonlySet<string>>;

/**
 * Finds import cycles: for each group of names that reach each other, one shortest cycle. It starts at the first name of the group in
 * alphabetical order.
 */
export function findCircles(graph: Graph): string[][] {
  const circles: string[][] = [];
  const told = new Set<string>();
  for (const name of [...graph.keys()].sort()) {
    if (told.has(name)) continue;
    const circle = circleThrough(graph, name);
    if (circle === null) continue;
    circles.push(circle);
    for (const other of groupOf(graph, name)) told.add(other);
  }
  return circles;
}

/** The shortest cycle through a name, by breadth-first search; null if there is none. */
function circleThrough(graph: Graph, start: string): string[] | null {
  const before = new Map<string, string>();
  const waiting = [start];
  for (const at of waiting) {
    for (const next of graph.get(at) ?? []) {
      if (next === start) return wayTo(before, start, at);
      if (before.has(next)) continue;
      before.set(next, at);
      waiting.push(next);
    }
  }
  return null;
}

function wayTo(before: ReadonlyMap<string, string>, start: string, end: string): string[] {
  const way = [end];
  for (let at = end; at !== start; ) {
    at = before.get(at) ?? start;
    way.unshift(at);
  }
  return way;
}

/** All names that this name reaches and that reach it. */
function groupOf(graph: Graph, name: string): readonly string[] {
  const reached = reach(graph, name);
  return [...reached].filter((other) => reach(graph, other).has(name));
}

function reach(graph: Graph, start: string): ReadonlySet<string> {
  const reached = new Set([start]);
  for (const at of reached) for (const next of graph.get(at) ?? []) reached.add(next);
  return reached;
}
