import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { createFaceLookup } from '../library/faces.ts';
import { nodesBehind, screensOf } from '../liveness.ts';
import { subgraphName } from '../names.ts';
import { own, sortedEntries } from '../own.ts';
import { type Graph, MAIN_GRAPH, type ProjectLogic } from '../project.ts';
import { checkNodeTypes, checkScreens } from './check-nodes.ts';
import { checkParams } from './check-params.ts';
import { checkAssetPaths, checkGraphs } from './check-project.ts';
import { checkCycles, checkExposed, checkRequiredInputs, checkWires } from './check-wires.ts';
import type { GraphCheck } from './context.ts';

const GRAPH_CHECKS = [checkNodeTypes, checkScreens, checkWires, checkCycles, checkRequiredInputs, checkExposed, checkParams];

/**
 * Everything wrong with a project by the node types of `library`, which is to include the project's own shaders
 * (`projectLibrary`). What only is unfinished, and nothing on screen depends on it, is a warning. Params of older versions are
 * not judged: `migrateNodes` first.
 */
export function validateProject(project: ProjectLogic, library: NodeLibrary): Diagnostic[] {
  const diagnostics = [...checkAssetPaths(project), ...checkGraphs(project)];
  const faceOf = createFaceLookup(project, library);
  const liveOf = liveNodes(project, library);
  for (const [name, graph] of sortedEntries(project.graphs)) {
    const live = liveOf.get(name) ?? NONE;
    const check: GraphCheck = { project, library, faceOf, name, graph, live, report: (diagnostic) => diagnostics.push(diagnostic) };
    for (const run of GRAPH_CHECKS) run(check);
  }
  return diagnostics;
}

const NONE: ReadonlySet<string> = new Set();

/** By graph, the nodes on which the screen depends: those of a subgraph only where such a node stands for it. */
function liveNodes(project: ProjectLogic, library: NodeLibrary): ReadonlyMap<string, ReadonlySet<string>> {
  const found = new Map<string, ReadonlySet<string>>();
  const visit = (name: string) => {
    const graph = own(project.graphs, name);
    if (!graph || found.has(name)) return;
    const live = nodesBehind(graph, rootsOf(name, graph, library));
    found.set(name, live);
    for (const id of live) visit(subgraphName(own(graph.nodes, id)?.type ?? '') ?? MAIN_GRAPH);
  };
  visit(MAIN_GRAPH);
  return found;
}

function rootsOf(name: string, graph: Graph, library: NodeLibrary): readonly string[] {
  return name === MAIN_GRAPH ? screensOf(graph, library) : graph.exposed.outputs.map(({ node }) => node);
}
