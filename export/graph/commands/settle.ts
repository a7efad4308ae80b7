import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { conversion } from '../../../nodes/kit/wire-types.ts';
import { bindingMisfit } from '../library/binding.ts';
import { createFaceLookup, type FaceLookup, inputOf, type NodeFace, takesSeveral } from '../library/faces.ts';
import { subgraphType } from '../names.ts';
import { own } from '../own.ts';
import type { ExposedPort, Graph, PortAddress, Project, Wire } from '../project.ts';
import { sameAddress } from '../wires.ts';
import { type Change, change, draftGraph, type ProjectDraft, setWires, unchanged } from './change.ts';

/**
 * After node types have changed their ports: takes away what hangs in the air. Wires stay whose port is still there under the
 * same name and takes the type; params stay whose value still fits; ports shown outside stay that are still there, and where one
 * goes, the graphs that use this one are settled too.
 */
export function settle(project: Project, library: NodeLibrary, types: Iterable<string>): Change {
  const pending = new Set(types);
  const steps: ((draft: ProjectDraft) => void)[] = [];
  let graphs = project.graphs;
  // The set grows while it is walked: a subgraph that lost a port has changed too.
  for (const type of pending) {
    const faceOf = createFaceLookup({ graphs }, library);
    const face = faceOf(type);
    if (!face) continue;
    for (const [name, graph] of Object.entries(graphs)) {
      const settled = settleGraph(graph, face, faceOf);
      if (settled === graph) continue;
      graphs = { ...graphs, [name]: settled };
      steps.push((draft) => takeOver(draft, name, graph, settled));
      if (settled.exposed !== graph.exposed) {
        // Once more if it has had its turn.
        pending.delete(subgraphType(name));
        pending.add(subgraphType(name));
      }
    }
  }
  return steps.length === 0 ? unchanged(project) : change(project, (draft) => steps.forEach((step) => void step(draft)));
}

function settleGraph(graph: Graph, face: NodeFace, faceOf: FaceLookup): Graph {
  const ids = new Set<string>();
  const nodes = { ...graph.nodes };
  let changed = false;
  for (const [id, node] of Object.entries(graph.nodes)) {
    if (node.type !== face.type) continue;
    ids.add(id);
    const kept = Object.entries(node.params).filter(([name, binding]) => {
      const param = own(face.params, name);
      return param !== undefined && bindingMisfit(param, binding) === null;
    });
    if (kept.length === Object.keys(node.params).length && node.version === face.version) continue;
    nodes[id] = { ...node, version: face.version, params: Object.fromEntries(kept) };
    changed = true;
  }
  if (ids.size === 0) return graph;
  const wires = oneWhereOneFits(
    graph.wires.filter((wire) => wireFits(graph, wire, ids, faceOf)),
    (to) => (ids.has(to.node) ? face : undefined),
  );
  const exposed = {
    inputs: graph.exposed.inputs.filter((port) => !ids.has(port.node) || canShow(face, port, wires)),
    outputs: graph.exposed.outputs.filter((port) => !ids.has(port.node) || own(face.outputs, port.port) !== undefined),
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

/** The wires without those beyond the first at ports that take one, of the nodes that `faceAt` knows. */
export function oneWhereOneFits(wires: readonly Wire[], faceAt: (to: PortAddress) => NodeFace | undefined): readonly Wire[] {
  return wires.filter(({ to }, index) => {
    const before = wires[index - 1];
    // In the order of the document, the wires of one port stand together.
    if (!before || !sameAddress(before.to, to)) return true;
    const face = faceAt(to);
    const input = face && inputOf(face, to.port);
    return !input || takesSeveral(input);
  });
}

/** Wires of other nodes are none of our business, even where they are wrong. */
function wireFits(graph: Graph, { from, to }: Wire, ids: ReadonlySet<string>, faceOf: FaceLookup): boolean {
  if (!ids.has(from.node) && !ids.has(to.node)) return true;
  const fromFace = faceAt(graph, from.node, faceOf);
  const toFace = faceAt(graph, to.node, faceOf);
  const output = fromFace && own(fromFace.outputs, from.port);
  const input = toFace && inputOf(toFace, to.port);
  // What hangs on a node of an unknown type cannot be judged.
  if (ids.has(from.node) && !output) return false;
  if (ids.has(to.node) && !input) return false;
  return !output || !input || conversion(output.type, input.type) !== 'none';
}

function faceAt(graph: Graph, id: string, faceOf: FaceLookup): NodeFace | undefined {
  const node = own(graph.nodes, id);
  return node && faceOf(node.type);
}

/** Still there; and not a port for one wire that has it from inside. */
function canShow(face: NodeFace, shown: ExposedPort, wires: readonly Wire[]): boolean {
  const input = inputOf(face, shown.port);
  if (!input) return own(face.params, shown.port) !== undefined;
  return takesSeveral(input) || !wires.some(({ to }) => sameAddress(to, shown));
}

function takeOver(draft: ProjectDraft, name: string, before: Graph, after: Graph): void {
  const graph = draftGraph(draft, name);
  for (const [id, node] of Object.entries(after.nodes)) if (node !== before.nodes[id]) graph.nodes[id] = castDraft(node);
  if (after.wires !== before.wires) setWires(draft, name, after.wires);
  if (after.exposed !== before.exposed) graph.exposed = castDraft(after.exposed);
}
