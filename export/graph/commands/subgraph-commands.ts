import { castDraft, current } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { isEntryId, isPortName, subgraphType } from '../document-names.ts';
import { createInterfaceLookup, inputOf, takesSeveral } from '../library/node-interface.ts';
import { EMPTY_GRAPH } from '../new-project.ts';
import { type ExposedPort, MAIN_GRAPH, type Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { sameAddress } from '../wires.ts';
import { carryRename } from './carry-rename.ts';
import { type Change, change, draftGraph, graphOf, refuse, sequence } from './change.ts';
import { pruneConnections } from './prune-connections.ts';

/**
 * Adds an empty subgraph, usable as node type `graph/NAME`.
 *
 * @returns The change, or a refusal with SCR020 if the name is invalid or in use.
 *
 * @example
 * addGraph(project, { name: 'glow' });
 */
export function addGraph(project: Project, { name }: { readonly name: string }): Change {
  return (
    nameProblem(project, name) ??
    change(project, (draft) => {
      draft.graphs[name] = castDraft(EMPTY_GRAPH);
    })
  );
}

/**
 * Renames a subgraph and updates its instances.
 *
 * @returns The change, or a refusal with SCR020 for the main graph, or if the name is invalid or in use.
 * @throws Error if the graph does not exist.
 *
 * @example
 * renameGraph(project, { from: 'glow', to: 'soft-glow' });
 */
export function renameGraph(project: Project, { from, to }: { readonly from: string; readonly to: string }): Change {
  graphOf(project, from);
  if (from === MAIN_GRAPH) return refuse(project, 'SCR020', 'The main graph cannot be renamed.');
  const problem = nameProblem(project, to);
  if (problem) return problem;
  const layout = getOwn(project.layout, from);
  return change(project, (draft) => {
    for (const [name, node] of usersOfGraph(project, from)) {
      const user = draftGraph(draft, name).nodes[node];
      if (user) user.type = subgraphType(to);
    }
    draft.graphs[to] = castDraft(current(draftGraph(draft, from)));
    delete draft.graphs[from];
    if (layout) {
      draft.layout[to] = castDraft(layout);
      delete draft.layout[from];
    }
  });
}

/**
 * Removes a subgraph.
 *
 * @returns The change, or a refusal with SCR020 for the main graph, or if the subgraph has instances.
 * @throws Error if the graph does not exist.
 *
 * @example
 * removeGraph(project, { name: 'glow' });
 */
export function removeGraph(project: Project, { name }: { readonly name: string }): Change {
  graphOf(project, name);
  if (name === MAIN_GRAPH) return refuse(project, 'SCR020', 'The main graph cannot be removed.');
  const [user] = usersOfGraph(project, name);
  if (user) return refuse(project, 'SCR020', `The subgraph “${name}” is used by ${user[1]} in “${user[0]}”.`, { nodeId: user[1] });
  return change(project, (draft) => {
    delete draft.graphs[name];
    delete draft.layout[name];
  });
}

export interface ExposePort extends ExposedPort {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly side: 'inputs' | 'outputs';
}

/**
 * Exposes a port or param of a node on the outside of its subgraph.
 *
 * @returns The change, or a refusal: SCR020 for the main graph; SCR012 if the name is invalid or in use, or the port does not exist or is
 * already exposed; SCR016 if the port takes one wire and is connected.
 * @throws Error if the graph does not exist.
 *
 * @example
 * exposePort(project, { library, graph: 'glow', side: 'inputs', name: 'radius', node: 'blur-x7k2', port: 'radius' });
 */
export function exposePort(project: Project, { library, graph: graphName, side, name, node: id, port }: ExposePort): Change {
  const graph = graphOf(project, graphName);
  const place = { nodeId: id, port };
  if (graphName === MAIN_GRAPH) return refuse(project, 'SCR020', 'The main graph cannot expose ports.', place);
  if (!isPortName(name)) return refuse(project, 'SCR012', `Port name “${name}” is invalid. Use letters, digits and underscores.`, place);
  const shown = graph.exposed[side];
  if ([...graph.exposed.inputs, ...graph.exposed.outputs].some((other) => other.name === name)) {
    return refuse(project, 'SCR012', `A port named “${name}” is already exposed.`, place);
  }
  if (shown.some((other) => sameAddress(other, { node: id, port })))
    return refuse(project, 'SCR012', `${id}.${port} is already exposed.`, place);
  const node = getOwn(graph.nodes, id);
  const nodeInterface = node && createInterfaceLookup(project, library)(node.type);
  const known =
    nodeInterface &&
    (getOwn<unknown>(nodeInterface[side], port) ?? (side === 'inputs' ? getOwn<unknown>(nodeInterface.params, port) : undefined));
  if (known === undefined) return refuse(project, 'SCR012', `${id}.${port} does not exist among the ${side}.`, place);
  const input = side === 'inputs' && nodeInterface ? inputOf(nodeInterface, port) : undefined;
  if (input && !takesSeveral(input) && graph.wires.some(({ to }) => sameAddress(to, { node: id, port }))) {
    return refuse(project, 'SCR016', `${id}.${port} is already connected and takes one wire. Disconnect it first.`, place);
  }
  return change(project, (draft) => {
    draftGraph(draft, graphName).exposed[side] = castDraft([...shown, { name, node: id, port }]);
  });
}

export interface HidePort {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly side: 'inputs' | 'outputs';
  readonly name: string;
}

/**
 * Removes an exposed port and the wires to it.
 *
 * @returns The change; this command is never refused.
 * @throws Error if the graph does not exist.
 *
 * @example
 * hidePort(project, { library, graph: 'glow', side: 'inputs', name: 'radius' });
 */
export function hidePort(project: Project, { library, graph, side, name }: HidePort): Change {
  const kept = graphOf(project, graph).exposed[side].filter((port) => port.name !== name);
  const hide = (before: Project) =>
    change(before, (draft) => {
      draftGraph(draft, graph).exposed[side] = castDraft(kept);
    });
  return sequence(project, hide, (before) => pruneConnections(before, library, [subgraphType(graph)]));
}

export interface RenameExposed {
  readonly graph: string;
  readonly side: 'inputs' | 'outputs';
  readonly from: string;
  readonly to: string;
}

/**
 * Renames an exposed port, with the wires, params and exposed ports of the instances.
 *
 * @returns The change, or a refusal with SCR012 if the name is invalid or in use.
 * @throws Error if the graph does not exist or does not expose the port.
 *
 * @example
 * renameExposed(project, { graph: 'glow', side: 'inputs', from: 'radius', to: 'softness' });
 */
export function renameExposed(project: Project, { graph: name, side, from, to }: RenameExposed): Change {
  const { exposed } = graphOf(project, name);
  if (!exposed[side].some((port) => port.name === from)) throw new Error(`The graph ${name} exposes no port ${from}.`);
  if (!isPortName(to)) return refuse(project, 'SCR012', `Port name “${to}” is invalid. Use letters, digits and underscores.`);
  if ([...exposed.inputs, ...exposed.outputs].some((port) => port.name === to)) {
    return refuse(project, 'SCR012', `A port named “${to}” is already exposed.`);
  }
  const rename = (before: Project) =>
    change(before, (draft) => {
      for (const port of draftGraph(draft, name).exposed[side]) if (port.name === from) port.name = to;
    });
  return sequence(project, rename, (before) => carryRename(before, subgraphType(name), { from, to }, side));
}

function nameProblem(project: Project, name: string): Change | null {
  if (!isEntryId(name)) return refuse(project, 'SCR020', `Subgraph name “${name}” is invalid. Use lower-case letters, digits and hyphens.`);
  return getOwn(project.graphs, name) ? refuse(project, 'SCR020', `A graph named “${name}” already exists.`) : null;
}

/**
 * @returns Graph and node id of each instance of the subgraph.
 *
 * @example
 * usersOfGraph(project, 'glow'); // [['main', 'glow-p3m9']]
 */
export function usersOfGraph(project: Project, name: string): [graph: string, node: string][] {
  const type = subgraphType(name);
  return Object.entries(project.graphs).flatMap(([graph, { nodes }]) =>
    Object.entries(nodes).flatMap(([id, node]): [string, string][] => (node.type === type ? [[graph, id]] : [])),
  );
}
