import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Binding } from '../graph/project.ts';

/**
 * The project as one graph: subgraphs are inlined, muted nodes bypassed and node types resolved. Inlined nodes have ids `outer/inner`.
 * Nodes of unknown types and wires to missing ports are left out; *check* reports them.
 */
export interface FlatGraph {
  readonly nodes: ReadonlyMap<string, FlatNode>;
  /** Exposed params of subgraphs: `outer.param` → `outer/inner.param`. */
  readonly aliases: ReadonlyMap<string, string>;
  /** Outputs of inlined or muted nodes, as `node.port` → the output that replaces it. */
  readonly replacements: ReadonlyMap<string, Source>;
  /** The output node; null if there is none or more than one. */
  readonly screen: FlatNode | null;
}

export interface FlatNode {
  readonly id: string;
  readonly definition: NodeDefinition;
  /** Whether its passes keep shaders of their own. */
  readonly unfused: boolean;
  /** Connected ports and params with their sources, in order. */
  readonly inputs: ReadonlyMap<string, readonly Source[]>;
  /** Bindings of the node, overridden by those of the subgraph's instance. */
  readonly bindings: ReadonlyMap<string, Binding>;
  /** Inputs that receive nothing, because their wire comes from a muted node that passes nothing through → id of that node. */
  readonly muteBlocked: ReadonlyMap<string, string>;
}

/** An output of a node. */
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

/**
 * Node → the nodes that act on it (`actsOn` of their definition), by ids. A node that acts on another one must run too, though nothing
 * reads its outputs.
 */
export function actorsOf(nodes: Iterable<FlatNode>): ReadonlyMap<string, readonly string[]> {
  const actors = new Map<string, string[]>();
  for (const { id, definition, inputs } of nodes) {
    if (definition.actsOn === undefined) continue;
    for (const { node } of inputs.get(definition.actsOn) ?? []) actors.set(node, [...(actors.get(node) ?? []), id]);
  }
  return actors;
}
