import type { LayerEncoding } from '../../nodes/kit/definition.ts';
import type { EncodedNode } from '../graph/layer-encoding.ts';
import { boundValue } from '../graph/library/param-value.ts';
import { type FlatNode, type Source, sourcesAt } from './flat-graph.ts';

/** A node of the flat graph, for the rules of `export/graph/layer-encoding.ts`. */
export function encodedNode(node: FlatNode, encodingOf: (source: Source) => LayerEncoding): EncodedNode {
  return {
    definition: node.definition,
    paramValue: (name) => {
      const binding = node.bindings.get(name);
      return (binding && boundValue(binding)) ?? node.definition.params[name]?.default;
    },
    encodingAt: (port) => {
      const [source] = sourcesAt(node, port);
      return source ? encodingOf(source) : null;
    },
  };
}
