import type { Program } from './program.ts';

const PHANTOM = 'objects/phantom';

/**
 * @returns The ids of the nodes whose objects reach a Phantom node, directly or through others: they stand for real objects.
 * @example
 * // box-a.objects -> phantom-a.objects
 * phantomNodes(program).has('box-a'); // true
 */
export function phantomNodes({ operations }: Program): ReadonlySet<string> {
  const nodes = new Set<string>();
  const wanted = operations.flatMap((operation) => ('type' in operation && operation.type === PHANTOM ? operation.reads : []));
  for (let resource = wanted.pop(); resource !== undefined; resource = wanted.pop()) {
    for (const { node, writes, reads } of operations) {
      if (nodes.has(node) || !writes.includes(resource)) continue;
      nodes.add(node);
      wanted.push(...reads);
    }
  }
  return nodes;
}
