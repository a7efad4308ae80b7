import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { conversion, type WireType } from '../../../nodes/kit/wire-types.ts';
import { subgraphType } from '../document-names.ts';
import { bindingMisfit } from '../library/binding-misfit.ts';
import { createInterfaceLookup, inputOf, type NodeInterface, takesSeveral } from '../library/node-interface.ts';
import type { Graph, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { sortWires } from '../wires.ts';
import { type Change, carryRoutes, change, draftGraph, graphOf, refuse, sequence, setWires } from './change.ts';
import { dropExtraWires, pruneConnections } from './prune-connections.ts';

export interface ChangeType {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly node: string;
  readonly type: string;
}

/**
 * Changes the type of a node. A wire stays at a port with the same name, or moves to the first free port of the same type. Params stay if
 * the new type has them and their bindings are valid there.
 *
 * @returns The change, or a refusal: SCR012 for an unknown node, SCR010 for an unknown type.
 * @throws Error if the graph does not exist.
 *
 * @example
 * const { project: next } = changeType(project, { library, graph: 'main', node: 'sepia-k7q2', type: 'filter/grey' });
 */
export function changeType(project: Project, { library, graph: name, node: id, type }: ChangeType): Change {
  const graph = graphOf(project, name);
  const node = getOwn(graph.nodes, id);
  if (!node) return refuse(project, 'SCR012', `Node ${id} does not exist.`, { nodeId: id });
  const interfaceOf = createInterfaceLookup(project, library);
  const nodeInterface = interfaceOf(type);
  if (!nodeInterface) return refuse(project, 'SCR010', `Node type ${type} does not exist.`, { nodeId: id });
  const params = Object.entries(node.params).filter(([param, binding]) => {
    const definition = getOwn(nodeInterface.params, param);
    return definition !== undefined && bindingMisfit(definition, binding) === null;
  });
  const moved = rewire(graph, id, interfaceOf(node.type), nodeInterface);
  const wires = dropExtraWires(sortWires(moved.map(([, after]) => after)), (to) => (to.node === id ? nodeInterface : undefined));
  const retype = (before: Project) =>
    change(before, (draft) => {
      const { nodes } = draftGraph(draft, name);
      nodes[id] = castDraft({ ...node, type, version: nodeInterface.version, params: Object.fromEntries(params) });
      setWires(draft, name, wires);
      carryRoutes(draft, name, moved);
    });
  // Removes wires that were invalid before, and exposed ports that no longer exist.
  return sequence(project, retype, (before) => pruneConnections(before, library, [type, subgraphType(name)]));
}

function rewire(
  graph: Graph,
  id: string,
  before: NodeInterface | undefined,
  after: NodeInterface,
): readonly (readonly [before: Wire, after: Wire])[] {
  const inputs = movePorts(
    graph.wires.filter(({ to }) => to.node === id).map(({ to }) => to.port),
    (port) => before && inputOf(before, port)?.type,
    [...Object.keys(after.inputs), ...Object.keys(after.params)].map((port) => ({ port, input: inputOf(after, port) })),
    ({ input }) => input?.type,
    ({ input }) => input !== undefined && takesSeveral(input),
  );
  const outputs = movePorts(
    graph.wires.filter(({ from }) => from.node === id).map(({ from }) => from.port),
    (port) => before && getOwn(before.outputs, port)?.type,
    Object.entries(after.outputs).map(([port, output]) => ({ port, output })),
    ({ output }) => output.type,
    () => true,
  );
  return graph.wires.flatMap((wire): [Wire, Wire][] => {
    const { from, to } = wire;
    const fromPort = from.node === id ? outputs.get(from.port) : from.port;
    const toPort = to.node === id ? inputs.get(to.port) : to.port;
    if (fromPort === undefined || toPort === undefined) return [];
    return [[wire, { from: { node: from.node, port: fromPort }, to: { node: to.node, port: toPort } }]];
  });
}

/** Old port → new port; ports without a match are absent. */
function movePorts<P extends { readonly port: string }>(
  used: readonly string[],
  typeBefore: (port: string) => WireType | undefined,
  available: readonly P[],
  typeOf: (port: P) => WireType | undefined,
  hasRoom: (port: P) => boolean,
): Map<string, string> {
  const moved = new Map<string, string>();
  const taken = new Set<string>();
  const unmatched: string[] = [];
  for (const port of new Set(used)) {
    const same = available.find((candidate) => candidate.port === port);
    const type = typeBefore(port);
    const sameType = same && typeOf(same);
    if (sameType && (type === undefined || conversion(type, sameType) !== 'none')) {
      moved.set(port, port);
      taken.add(port);
    } else unmatched.push(port);
  }
  for (const port of unmatched) {
    const type = typeBefore(port);
    const free = available.find((candidate) => typeOf(candidate) === type && (hasRoom(candidate) || !taken.has(candidate.port)));
    if (type === undefined || !free) continue;
    moved.set(port, free.port);
    taken.add(free.port);
  }
  return moved;
}
