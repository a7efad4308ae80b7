/**
 * Sorts the vertices of a directed graph topologically. Ties keep the given order. Iterative, in linear time.
 *
 * @param successors The vertices that depend on a vertex.
 * @returns `order`: each vertex after those it depends on. `left`: vertices on a cycle or behind one.
 * @example
 * topologicalOrder(['a', 'b'], (vertex) => (vertex === 'b' ? ['a'] : [])).order; // ['b', 'a']
 */
export function topologicalOrder<T>(
  vertices: Iterable<T>,
  successors: (vertex: T) => Iterable<T>,
): { readonly order: T[]; readonly left: Set<T> } {
  const waitsFor = new Map<T, number>();
  for (const vertex of vertices) waitsFor.set(vertex, 0);
  for (const vertex of waitsFor.keys()) {
    for (const next of successors(vertex)) waitsFor.set(next, (waitsFor.get(next) ?? 0) + 1);
  }
  const order = [...waitsFor].filter(([, count]) => count === 0).map(([vertex]) => vertex);
  // The list grows during the iteration.
  for (const vertex of order) {
    for (const next of successors(vertex)) {
      const count = (waitsFor.get(next) ?? 0) - 1;
      waitsFor.set(next, count);
      if (count === 0) order.push(next);
    }
  }
  const left = new Set<T>();
  if (order.length < waitsFor.size) {
    for (const [vertex, count] of waitsFor) if (count > 0) left.add(vertex);
  }
  return { order, left };
}

/**
 * Finds cycles in linear time, not necessarily all of them.
 *
 * @returns For each cycle its vertices, in the direction of the edges. Empty only if the graph has no cycle.
 */
export function findCycles<T>(vertices: Iterable<T>, successors: (vertex: T) => Iterable<T>): T[][] {
  const { left } = topologicalOrder(vertices, successors);
  if (left.size === 0) return [];
  const cyclic = withoutTails(left, successors);
  const cycles: T[][] = [];
  const walked = new Set<T>();
  for (const start of cyclic) {
    const path = new Set<T>();
    let vertex: T | undefined = start;
    while (vertex !== undefined && !walked.has(vertex)) {
      walked.add(vertex);
      path.add(vertex);
      vertex = firstIn(successors(vertex), cyclic);
    }
    if (vertex === undefined || !path.has(vertex)) continue;
    const along = [...path];
    cycles.push(along.slice(along.indexOf(vertex)));
  }
  return cycles;
}

/** Removes the vertices that depend on a cycle but lead to none. */
function withoutTails<T>(left: ReadonlySet<T>, successors: (vertex: T) => Iterable<T>): Set<T> {
  const predecessors = new Map<T, T[]>();
  for (const vertex of left) predecessors.set(vertex, []);
  for (const vertex of left) {
    for (const next of successors(vertex)) predecessors.get(next)?.push(vertex);
  }
  return topologicalOrder(left, (vertex) => predecessors.get(vertex) ?? []).left;
}

function firstIn<T>(items: Iterable<T>, set: ReadonlySet<T>): T | undefined {
  for (const item of items) if (set.has(item)) return item;
  return undefined;
}
