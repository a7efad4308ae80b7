import { castDraft } from 'immer';
import type { NodeLibrary, ParamValue } from '../../../nodes/kit/definition.ts';
import { isNodeId, subgraphName, subgraphType } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { MAIN_GRAPH, type Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { type Change, change, draftGraph, graphOf, type ProjectDraft, refuse, sequence, setWires } from './change.ts';
import { setParam } from './param-commands.ts';
import { pruneConnections } from './prune-connections.ts';

export interface AddNode {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** From `makeNodeId`. */
  readonly id: string;
  readonly type: string;
  /** Position in canvas units. */
  readonly x: number;
  readonly y: number;
  /** Values that differ from the defaults. */
  readonly params?: Readonly<Record<string, ParamValue>>;
}

/**
 * Adds a node of a type of the library or of a subgraph.
 *
 * @returns The change, or a refusal: SCR010 for an unknown type, SCR020 if a subgraph would contain itself, or that of `setParam`.
 * @throws Error if the graph does not exist, the id is invalid or it is in use.
 *
 * @example
 * const id = makeNodeId(project, 'filter/sepia', random);
 * const { project: next } = addNode(project, { library, graph: 'main', id, type: 'filter/sepia', x: 240, y: 80 });
 */
export function addNode(project: Project, { library, graph, id, type, x, y, params = {} }: AddNode): Change {
  if (!isNodeId(id)) throw new Error(`${id} is not a node id.`);
  if (getOwn(graphOf(project, graph).nodes, id)) throw new Error(`Node ${id} already exists.`);
  const nodeInterface = createInterfaceLookup(project, library)(type);
  if (!nodeInterface) return refuse(project, 'SCR010', `Node type ${type} does not exist.`);
  const inner = subgraphName(type);
  if (inner !== null && (inner === MAIN_GRAPH || usesGraph(project, inner, graph))) {
    return refuse(project, 'SCR020', `The subgraph “${inner}” cannot be added to “${graph}”: it would contain itself.`);
  }
  const add = (before: Project) =>
    change(before, (draft) => {
      // Adding 0 converts −0, which JSON cannot represent.
      draftGraph(draft, graph).nodes[id] = { type, version: nodeInterface.version, params: {} };
      draftLayout(draft, graph).nodes[id] = { x: Math.round(x) + 0, y: Math.round(y) + 0 };
    });
  const set = Object.entries(params).map(
    ([param, value]) =>
      (before: Project) =>
        setParam(before, { library, graph, node: id, param, value }),
  );
  return sequence(project, add, ...set);
}

export interface RemoveNodes {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly nodes: readonly string[];
}

/**
 * Removes nodes with their wires, positions and exposed ports.
 *
 * @returns The change; this command is never refused.
 * @throws Error if the graph does not exist.
 *
 * @example
 * removeNodes(project, { library, graph: 'main', nodes: ['sepia-k7q2'] });
 */
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
  return sequence(project, remove, (before) => pruneConnections(before, library, shown ? [subgraphType(graph)] : []));
}

export interface SetMuted {
  readonly graph: string;
  readonly nodes: readonly string[];
  readonly muted: boolean;
}

/**
 * Mutes or unmutes nodes. A muted node is bypassed: its first layer passes through. Unknown ids are ignored.
 *
 * @returns The change; this command is never refused.
 * @throws Error if the graph does not exist.
 *
 * @example
 * setMuted(project, { graph: 'main', nodes: ['sepia-k7q2'], muted: true });
 */
export function setMuted(project: Project, { graph, nodes, muted }: SetMuted): Change {
  return change(project, (draft) => setFlag(draftGraph(draft, graph).nodes, nodes, 'muted', muted));
}

export interface SetUnfused {
  readonly graph: string;
  readonly nodes: readonly string[];
  readonly unfused: boolean;
}

/**
 * Turns the fusion of the passes of nodes off or on. For a subgraph, this holds for all nodes in it. Unknown ids are ignored.
 *
 * @returns The change; this command is never refused.
 * @throws Error if the graph does not exist.
 *
 * @example
 * setUnfused(project, { graph: 'main', nodes: ['sepia-k7q2'], unfused: true });
 */
export function setUnfused(project: Project, { graph, nodes, unfused }: SetUnfused): Change {
  return change(project, (draft) => setFlag(draftGraph(draft, graph).nodes, nodes, 'unfused', unfused));
}

function setFlag(drafted: ReturnType<typeof draftGraph>['nodes'], ids: readonly string[], flag: 'muted' | 'unfused', value: boolean): void {
  for (const id of ids) {
    const node = drafted[id];
    if (!node) continue;
    if (value) node[flag] = true;
    else delete node[flag];
  }
}

export function draftLayout(draft: ProjectDraft, graph: string) {
  draft.layout[graph] ??= castDraft({ nodes: {}, frames: {}, notes: {}, reroutes: {}, routes: {} });
  return draft.layout[graph];
}

/**
 * Whether the graph `used` is `graph` or uses it, directly or through other subgraphs.
 *
 * @example
 * usesGraph(project, 'glow', 'glow'); // true
 * usesGraph(project, 'look', 'glow'); // true if `look` has a node of the type `graph/glow`
 */
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
