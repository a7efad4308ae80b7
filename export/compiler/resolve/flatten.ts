import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';
import { subgraphName } from '../../graph/document-names.ts';
import type { InterfaceLookup } from '../../graph/library/node-interface.ts';
import type { Binding, GraphNode } from '../../graph/project.ts';
import { sortedEntries } from '../../graph/record.ts';
import type { Source } from '../flat-graph.ts';
import { createInnerPortLookup, type Instance } from './instances.ts';

/** A node of the flat graph under construction. */
export interface DraftNode {
  readonly id: string;
  readonly definition: NodeDefinition;
  readonly muted: boolean;
  readonly unfused: boolean;
  readonly inputs: Map<string, Source[]>;
  readonly bindings: Map<string, Binding>;
}

export interface Draft {
  readonly nodes: Map<string, DraftNode>;
  readonly aliases: Map<string, string>;
  /** Exposed outputs: `outer.port` → the output inside. */
  readonly shown: Map<string, Source>;
}

/**
 * Inlines all instances into one graph. If a port takes several wires from inside and outside of its subgraph, those from outside come
 * first.
 */
export function flatten(instances: readonly Instance[], interfaceOf: InterfaceLookup, library: NodeLibrary): Draft {
  const draft: Draft = { nodes: new Map(), aliases: new Map(), shown: new Map() };
  for (const instance of instances) addNodes(draft, instance, interfaceOf, library);
  addWires(draft, instances);
  addShownOutputs(draft, instances);
  addOuterBindings(draft, instances);
  return draft;
}

function addNodes({ nodes }: Draft, { prefix, graph, unfused: all }: Instance, interfaceOf: InterfaceLookup, library: NodeLibrary): void {
  for (const [id, node] of sortedEntries(graph.nodes)) {
    const definition = subgraphName(node.type) === null ? library.definition(node.type) : mutedSubgraph(node, interfaceOf);
    if (!definition) continue;
    const bindings = new Map(Object.entries(node.params));
    const flags = { muted: node.muted === true, unfused: all || node.unfused === true };
    nodes.set(prefix + id, { id: prefix + id, definition, ...flags, inputs: new Map(), bindings });
  }
}

/** The definition of a muted subgraph, which stays one node until it is bypassed, so its lowering does not matter. */
function mutedSubgraph({ type, muted }: GraphNode, interfaceOf: InterfaceLookup): NodeDefinition | undefined {
  const nodeInterface = muted === true ? interfaceOf(type) : undefined;
  return nodeInterface && { ...nodeInterface, lowering: { kind: 'behavior' } };
}

function addWires({ nodes }: Draft, instances: readonly Instance[]): void {
  const findSource = createInnerPortLookup('outputs');
  const findTarget = createInnerPortLookup('inputs');
  for (const instance of instances) {
    for (const { from, to } of instance.graph.wires) {
      const source = findSource(instance, from);
      const target = findTarget(instance, to);
      const node = target && nodes.get(target.node);
      if (!source || !node || !nodes.has(source.node)) continue;
      const wires = node.inputs.get(target.port);
      if (wires) wires.push(source);
      else node.inputs.set(target.port, [source]);
    }
  }
}

function addShownOutputs({ shown }: Draft, instances: readonly Instance[]): void {
  const findSource = createInnerPortLookup('outputs');
  for (const instance of instances) {
    for (const [id, child] of instance.children) {
      for (const { name } of child.graph.exposed.outputs) {
        const source = findSource(instance, { node: id, port: name });
        if (source) shown.set(`${instance.prefix}${id}.${name}`, source);
      }
    }
  }
}

/** Applies bindings of subgraph instances to the nodes inside; those of the outermost instance win. */
function addOuterBindings({ nodes, aliases }: Draft, instances: readonly Instance[]): void {
  const findTarget = createInnerPortLookup('inputs');
  const set = new Set<string>();
  for (const instance of instances) {
    for (const [id, child] of instance.children) {
      const outer = instance.graph.nodes[id];
      for (const { name } of child.graph.exposed.inputs) {
        const place = findTarget(instance, { node: id, port: name });
        const inner = place && nodes.get(place.node);
        if (!inner || !Object.hasOwn(inner.definition.params, place.port)) continue;
        const address = `${place.node}.${place.port}`;
        aliases.set(`${instance.prefix}${id}.${name}`, address);
        const binding = outer && Object.hasOwn(outer.params, name) ? outer.params[name] : undefined;
        if (binding === undefined || set.has(address)) continue;
        set.add(address);
        inner.bindings.set(place.port, binding);
      }
    }
  }
}
