import { replacedParams } from '../../graph/library/replaced-params.ts';
import type { FlatNode } from '../flat-graph.ts';

/**
 * Removes what is bound to params that a connected input replaces, so that no later phase loads a file or computes a value for them. A wire
 * from a muted node counts, though it brings nothing: the params would show what it does not stand for.
 */
export function dropReplaced(node: FlatNode): FlatNode {
  const replaced = replacedParams(node.definition, (port) => node.inputs.has(port) || node.muteBlocked.has(port));
  if (replaced.size === 0) return node;
  const inputs = new Map([...node.inputs].filter(([port]) => !replaced.has(port)));
  const bindings = new Map([...node.bindings].filter(([param]) => !replaced.has(param)));
  return { ...node, inputs, bindings };
}
