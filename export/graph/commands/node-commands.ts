import { castDraft } from 'immer';
import type { NodeLibrary, ParamValue } from '../../../nodes/kit/definition.ts';
import { isNodeId, subgraphName, subgraphType } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { MAIN_GRAPH, type Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { type Change, change, draftGraph, graphOf, inTurn, type ProjectDraft, refuse, setWires } from './change.ts';
import { setParam } from './param-commands.ts';
import { pruneConnections } from './prune-connections.ts';

export interface AddNode {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** From `makeNodeId`. */
  readonly id: string;
  readonly type: string;
  /** Canvas units. */
  readonly x: number;
  readonly y: number;
  /** Values that differ from the type's own. */
  readonly params?: Readonly<Record<string, ParamValue>>;
}

/** A node of a known type: the library's, or a subgraph. */
export function addNode(project: Project, { library, graph, id, type, x, y, params = {} }: AddNode): Change {
  if (!isNodeId(id)) throw new Error(`${id} is no node id.`);
  if (getOwn(graphOf(project, graph).nodes, id)) throw new Error(`There is a node ${id} already.`);
  const nodeInterface = createInterfaceLookup(project, library)(type);
  if (!nodeInterface) return refuse(project, 'SCR010', `Node type ${type} does not exist.`);
  const inner = subgraphName(type);
  if (inner !== null && (inner === MAIN_GRAPH || usesGraph(project, inner, graph))) {
    return refuse(project, 'SCR020', `The subgraph “${inner}” cannot be added to “${graph}”: it would contain itself.`);
  }
  const add = (before: Project) =>
    change(before, (draft) => {
      // Adding zero turns the negative zero of JavaScript, which JSON cannot write, into zero.
      draftGraph(draft, graph).nodes[id] = { type, version: nodeInterface.version, params: {} };
      draftLayout(draft, graph).nodes[id] = { x: Math.round(x) + 0, y: Math.round(y) + 0 };
    });
  const set = Object.entries(params).map(
    ([param, value]) =>
      (before: Project) =>
        setParam(before, { library, graph, node: id, param, value }),
  );
  return inTurn(project, add, ...set);
}

export interface RemoveNodes {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly nodes: readonly string[];
}

/** Removes nodes with their wires, their positions on the canvas and their exposed ports. */
export function removeNodes(project: Project, { library, graph, nodes }: RemoveNodes): Change {
  const gone = new Set(nodes);
  const { wires, exposed } = graphOf(project, graph);
  const shown = [...exposed.inputs, ...exposed.outputs].some(({ node }) => gone.has(node));
  const remove = (before: Project) =>
    change(before, (draft) => {
      const drafted = draftGraph(draft, graph);
      for (const id of gone) {
        delete drafted.nodes[id];
        delete draft.layout[graph]?.nodes[id];
      }
      const kept = wires.filter(({ from, to }) => !gone.has(from.node) && !gone.has(to.node));
      if (kept.length < wires.length) setWires(draft, graph, kept);
      if (shown) {
        drafted.exposed = castDraft({
          inputs: exposed.inputs.filter(({ node }) => !gone.has(node)),
          outputs: exposed.outputs.filter(({ node }) => !gone.has(node)),
        });
      }
    });
  return inTurn(project, remove, (before) => pruneConnections(before, library, shown ? [subgraphType(graph)] : []));
}

export interface SetMuted {
  readonly graph: string;
  readonly nodes: readonly string[];
  readonly muted: boolean;
}

/** A muted node is bypassed: its first layer passes through. */
export function setMuted(project: Project, { graph, nodes, muted }: SetMuted): Change {
  return change(project, (draft) => {
    const drafted = draftGraph(draft, graph).nodes;
    for (const id of nodes) {
      const node = drafted[id];
      if (!node) continue;
      if (muted) node.muted = true;
      else delete node.muted;
    }
  });
}

export function draftLayout(draft: ProjectDraft, graph: string) {
  draft.layout[graph] ??= castDraft({ nodes: {}, frames: {}, notes: {}, reroutes: {}, routes: {} });
  return draft.layout[graph];
}

/** Whether `graph` is `used`, or is used by it, directly or through others. */
export function usesGraph(project: Project, used: string, graph: string): boolean {
  const reached = new Set([used]);
  for (const name of reached) {
    if (name === graph) return true;
    for (const node of Object.values(getOwn(project.graphs, name)?.nodes ?? {})) {
      const inner = subgraphName(node.type);
      if (inner !== null) reached.add(inner);
    }
  }
  return false;
}
