import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { findCycles, topologicalOrder } from './topology.ts';

type Edges = readonly (readonly [number, number])[];

const graphs = fc.integer({ min: 1, max: 12 }).chain((count) => {
  const vertex = fc.nat(count - 1);
  return fc.record({ count: fc.constant(count), edges: fc.array(fc.tuple(vertex, vertex), { maxLength: 24 }) });
});

function successorsOf(edges: Edges) {
  return (vertex: number) => edges.filter(([from]) => from === vertex).map(([, to]) => to);
}

/** By marking all that can be reached, as often as there are vertices: small and nothing like the code under test. */
function hasCycle(count: number, edges: Edges): boolean {
  const reached = new Set(edges.map(([from, to]) => `${from} ${to}`));
  for (let round = 0; round < count; round++) {
    for (const [from, to] of edges) {
      for (let end = 0; end < count; end++) if (reached.has(`${to} ${end}`)) reached.add(`${from} ${end}`);
    }
  }
  return Array.from({ length: count }, (_, i) => i).some((vertex) => reached.has(`${vertex} ${vertex}`));
}

describe('topologicalOrder', () => {
  test('puts everything after what it depends on', () => {
    fc.assert(
      fc.property(graphs, ({ count, edges }) => {
        const { order, left } = topologicalOrder(
          Array.from({ length: count }, (_, i) => i),
          successorsOf(edges),
        );
        expect(order.length + left.size).toBe(count);
        for (const [from, to] of edges) if (!left.has(to)) expect(order.indexOf(from)).toBeLessThan(order.indexOf(to));
        expect(left.size > 0).toBe(hasCycle(count, edges));
      }),
      { seed: 1 },
    );
  });
});

describe('findCycles', () => {
  test('gives real cycles, and some exactly where there are some', () => {
    fc.assert(
      fc.property(graphs, ({ count, edges }) => {
        const cycles = findCycles(
          Array.from({ length: count }, (_, i) => i),
          successorsOf(edges),
        );
        expect(cycles.length > 0).toBe(hasCycle(count, edges));
        for (const cycle of cycles) {
          for (const [i, vertex] of cycle.entries()) expect(successorsOf(edges)(vertex)).toContain(cycle[(i + 1) % cycle.length]);
        }
      }),
      { seed: 1 },
    );
  });

  test('does not overflow the stack on a loop of 100,000', () => {
    const next = (vertex: number) => [(vertex + 1) % 100_000];
    expect(
      findCycles(
        Array.from({ length: 100_000 }, (_, i) => i),
        next,
      ),
    ).toHaveLength(1);
  });
});
