import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { conversion } from '../../../nodes/kit/wire-types.ts';
import { subgraphType } from '../document-names.ts';
import { bindingMisfit } from '../library/binding-misfit.ts';
import { createInterfaceLookup, type InterfaceLookup, inputOf, type NodeInterface, takesSeveral } from '../library/node-interface.ts';
import type { ExposedPort, Graph, PortAddress, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { sameAddress } from '../wires.ts';
import { type Change, change, draftGraph, type ProjectDraft, setWires, unchanged } from './change.ts';

/**
 * Removes connections that are no longer valid after node types have changed: wires to missing ports or between incompatible types,
 * bindings that the param does not support, and exposed ports that do not exist. If a subgraph loses an exposed port, graphs that use it
 * are pruned too.
 *
 * @param library Node types after the change.
 * @param types The changed node types.
 * @returns One change over all graphs, without patches if everything is still valid.
 */
export function pruneConnections(project: Project, library: NodeLibrary, types: Iterable<string>): Change {
  const pending = new Set(types);
  const steps: ((draft: ProjectDraft) => void)[] = [];
  let graphs = project.graphs;
  // The set grows during the iteration: a subgraph that loses a port changes its type.
  for (const type of pending) {
    const interfaceOf = createInterfaceLookup({ graphs }, library);
    const nodeInterface = interfaceOf(type);
    if (!nodeInterface) continue;
    for (const [name, graph] of Object.entries(graphs)) {
      const pruned = pruneGraph(graph, nodeInterface, interfaceOf);
      if (pruned === graph) continue;
      graphs = { ...graphs, [name]: pruned };
      steps.push((draft) => takeOver(draft, name, graph, pruned));
      if (pruned.exposed !== graph.exposed) {
        // Once more if it has had its turn.
        pending.delete(subgraphType(name));
        pending.add(subgraphType(name));
      }
    }
  }
  return steps.length === 0 ? unchanged(project) : change(project, (draft) => steps.forEach((step) => void step(draft)));
}

function pruneGraph(graph: Graph, nodeInterface: NodeInterface, interfaceOf: InterfaceLookup): Graph {
  const ids = new Set<string>();
  const nodes = { ...graph.nodes };
  let changed = false;
  for (const [id, node] of Object.entries(graph.nodes)) {
    if (node.type !== nodeInterface.type) continue;
    ids.add(id);
    const kept = Object.entries(node.params).filter(([name, binding]) => {
      const param = getOwn(nodeInterface.params, name);
      return param !== undefined && bindingMisfit(param, binding) === null;
    });
    if (kept.length === Object.keys(node.params).length && node.version === nodeInterface.version) continue;
    nodes[id] = { ...node, version: nodeInterface.version, params: Object.fromEntries(kept) };
    changed = true;
  }
  if (ids.size === 0) return graph;
  const wires = dropExtraWires(
    graph.wires.filter((wire) => wireFits(graph, wire, ids, interfaceOf)),
    (to) => (ids.has(to.node) ? nodeInterface : undefined),
  );
  const exposed = {
    inputs: graph.exposed.inputs.filter((port) => !ids.has(port.node) || canShow(nodeInterface, port, wires)),
    outputs: graph.exposed.outputs.filter((port) => !ids.has(port.node) || getOwn(nodeInterface.outputs, port.port) !== undefined),
  };
  const sameWires = wires.length === graph.wires.length;
  const sameExposed = exposed.inputs.length === graph.exposed.inputs.length && exposed.outputs.length === graph.exposed.outputs.length;
  if (!changed && sameWires && sameExposed) return graph;
  return {
    nodes: changed ? nodes : graph.nodes,
    wires: sameWires ? graph.wires : wires,
    exposed: sameExposed ? graph.exposed : exposed,
  };
}

/** Keeps the first wire at each single-wire port of the nodes whose interface `interfaceAt` returns. */
export function dropExtraWires(wires: readonly Wire[], interfaceAt: (to: PortAddress) => NodeInterface | undefined): readonly Wire[] {
  return wires.filter(({ to }, index) => {
    const before = wires[index - 1];
    // In document order, wires of the same port are adjacent.
    if (!before || !sameAddress(before.to, to)) return true;
    const nodeInterface = interfaceAt(to);
    const input = nodeInterface && inputOf(nodeInterface, to.port);
    return !input || takesSeveral(input);
  });
}

/** Whether a wire is kept: it is valid, or connects none of the nodes `ids`. Wires to nodes of unknown types count as valid at that end. */
function wireFits(graph: Graph, { from, to }: Wire, ids: ReadonlySet<string>, interfaceOf: InterfaceLookup): boolean {
  if (!ids.has(from.node) && !ids.has(to.node)) return true;
  const fromInterface = interfaceAt(graph, from.node, interfaceOf);
  const toInterface = interfaceAt(graph, to.node, interfaceOf);
  const output = fromInterface && getOwn(fromInterface.outputs, from.port);
  const input = toInterface && inputOf(toInterface, to.port);
  // Wires to nodes of unknown types cannot be checked.
  if (ids.has(from.node) && !output) return false;
  if (ids.has(to.node) && !input) return false;
  return !output || !input || conversion(output.type, input.type) !== 'none';
}

function interfaceAt(graph: Graph, id: string, interfaceOf: InterfaceLookup): NodeInterface | undefined {
  const node = getOwn(graph.nodes, id);
  return node && interfaceOf(node.type);
}

/** Whether a port can stay exposed: it exists and is not a single-wire input that is already connected inside. */
function canShow(nodeInterface: NodeInterface, shown: ExposedPort, wires: readonly Wire[]): boolean {
  const input = inputOf(nodeInterface, shown.port);
  if (!input) return getOwn(nodeInterface.params, shown.port) !== undefined;
  return takesSeveral(input) || !wires.some(({ to }) => sameAddress(to, shown));
}

function takeOver(draft: ProjectDraft, name: string, before: Graph, after: Graph): void {
  const graph = draftGraph(draft, name);
  for (const [id, node] of Object.entries(after.nodes)) if (node !== before.nodes[id]) graph.nodes[id] = castDraft(node);
  if (after.wires !== before.wires) setWires(draft, name, after.wires);
  if (after.exposed !== before.exposed) graph.exposed = castDraft(after.exposed);
}
