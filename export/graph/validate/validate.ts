import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { subgraphName } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { nodesBehind, screensOf } from '../liveness.ts';
import { type Graph, MAIN_GRAPH, type ProjectLogic } from '../project.ts';
import { getOwn, sortedEntries } from '../record.ts';
import { checkNodeTypes, checkScreens } from './check-node-types.ts';
import { checkParams } from './check-params.ts';
import { checkAssetPaths, checkGraphs } from './check-project.ts';
import { checkCycles, checkExposed, checkRequiredInputs, checkWires } from './check-wires.ts';
import type { GraphCheck } from './context.ts';

const GRAPH_CHECKS = [checkNodeTypes, checkScreens, checkWires, checkCycles, checkRequiredInputs, checkExposed, checkParams];

/**
 * Finds all mistakes in a project. Unfinished work that the output does not depend on gives warnings. Params of older versions
 * are not checked: call `migrateNodes` first.
 *
 * @param library Node types, with the project's own shaders (`projectLibrary`).
 * @returns All diagnostics, graph by graph in the order of their names.
 * @example
 * const { project } = migrateNodes(loaded, library);
 * const isValid = !hasErrors(validateProject(project, library));
 */
export function validateProject(project: ProjectLogic, library: NodeLibrary): Diagnostic[] {
  const diagnostics = [...checkAssetPaths(project), ...checkGraphs(project)];
  const interfaceOf = createInterfaceLookup(project, library);
  const liveOf = liveNodes(project, library);
  for (const [name, graph] of sortedEntries(project.graphs)) {
    const live = liveOf.get(name) ?? NONE;
    const check: GraphCheck = { project, library, interfaceOf, name, graph, live, report: (diagnostic) => diagnostics.push(diagnostic) };
    for (const run of GRAPH_CHECKS) run(check);
  }
  return diagnostics;
}

const NONE: ReadonlySet<string> = new Set();

/** Per graph, the nodes that the output depends on. Nodes of a subgraph count if an instance of it does. */
function liveNodes(project: ProjectLogic, library: NodeLibrary): ReadonlyMap<string, ReadonlySet<string>> {
  const found = new Map<string, ReadonlySet<string>>();
  const visit = (name: string) => {
    const graph = getOwn(project.graphs, name);
    if (!graph || found.has(name)) return;
    const live = nodesBehind(graph, rootsOf(name, graph, library));
    found.set(name, live);
    for (const id of live) visit(subgraphName(getOwn(graph.nodes, id)?.type ?? '') ?? MAIN_GRAPH);
  };
  visit(MAIN_GRAPH);
  return found;
}

function rootsOf(name: string, graph: Graph, library: NodeLibrary): readonly string[] {
  return name === MAIN_GRAPH
    ? [...screensOf(graph, library), ...heardNodes(graph, library)]
    : graph.exposed.outputs.map(({ node }) => node);
}

/** Nodes that play sound and that something is connected to. */
function heardNodes(graph: Graph, library: NodeLibrary): readonly string[] {
  const connected = new Set(graph.wires.map(({ to }) => to.node));
  return Object.entries(graph.nodes).flatMap(([id, { type }]) => (connected.has(id) && library.definition(type)?.heard ? [id] : []));
}
