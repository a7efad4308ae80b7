import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Binding } from '../graph/project.ts';

/**
 * The project as one graph: subgraphs put in the place of the nodes that use them, muted nodes bypassed, node types looked up.
 * Ids of inlined nodes are `outer/inner`. Nodes of unknown types, and wires to nothing, are left out: *check* tells of them.
 */
export interface FlatGraph {
  readonly nodes: ReadonlyMap<string, FlatNode>;
  /** Params that subgraphs show outside: `outer.param` → `outer/inner.param`. */
  readonly aliases: ReadonlyMap<string, string>;
  /** Outputs of nodes that are not there any more, inlined or muted, as `node.port` → the output that stands in for it. */
  readonly standIns: ReadonlyMap<string, Source>;
  /** What the screen shows; null where there is none, or more than one. */
  readonly screen: FlatNode | null;
}

export interface FlatNode {
  readonly id: string;
  readonly definition: NodeDefinition;
  /** Ports and params with wires, in order. */
  readonly inputs: ReadonlyMap<string, readonly Source[]>;
  /** Saved with the node, or set from outside its subgraph. */
  readonly bindings: ReadonlyMap<string, Binding>;
  /** Inputs that lost their wires because what they came from is muted and lets nothing through. */
  readonly cutOff: ReadonlyMap<string, string>;
}

/** An output port. */
export interface Source {
  readonly node: string;
  readonly port: string;
}

const NO_SOURCES: readonly Source[] = [];

export function sourcesAt(node: FlatNode, port: string): readonly Source[] {
  return node.inputs.get(port) ?? NO_SOURCES;
}

export function portKey({ node, port }: Source): string {
  return `${node}.${port}`;
}
