import { shaderFilesOf, subgraphName } from '../document-names.ts';
import { screensOf } from '../liveness.ts';
import { MAIN_GRAPH } from '../project.ts';
import { getOwn } from '../record.ts';
import { type GraphCheck, reportError } from './context.ts';

/** Types must be known and not newer than those of the library. */
export function checkNodeTypes(check: GraphCheck): void {
  const { graph, library, project } = check;
  for (const [nodeId, node] of Object.entries(graph.nodes)) {
    const inner = subgraphName(node.type);
    if (inner !== null) {
      if (inner === MAIN_GRAPH) reportError(check, 'SCR020', { nodeId }, `${nodeId} uses the main graph, which cannot be used as a node.`);
      else if (!getOwn(project.graphs, inner))
        reportError(check, 'SCR020', { nodeId }, `${nodeId} uses the subgraph “${inner}”, which does not exist.`);
      continue;
    }
    const definition = library.definition(node.type);
    if (!definition) reportError(check, 'SCR010', { nodeId }, unknownType(check, nodeId, node.type), 'Replace or delete the node.');
    else if (node.version > definition.version) {
      const message = `${nodeId} (${node.type}) has version ${node.version}, but this Scrim has version ${definition.version} of its type.`;
      reportError(check, 'SCR011', { nodeId }, message, 'Open the project with a newer Scrim.');
    }
  }
}

function unknownType({ project }: GraphCheck, nodeId: string, type: string): string {
  const file = shaderFilesOf(type).find((name) => getOwn(project.sources, name) !== undefined);
  if (file === undefined) return `${nodeId} has the unknown type ${type}.`;
  return `${nodeId} has the type ${type}, but shaders/${file} does not define it. Its header is invalid, or its inputs define another type.`;
}

/** The main graph has one output, subgraphs have none. */
export function checkScreens(check: GraphCheck): void {
  const screens = screensOf(check.graph, check.library);
  const [first, ...more] = screens;
  if (check.name !== MAIN_GRAPH) {
    for (const nodeId of screens) reportError(check, 'SCR017', { nodeId }, `${nodeId} is an output, which only the main graph can have.`);
  } else if (first === undefined && check.project.recipe) {
    const fix = 'Add it to another project from the palette. To see it here, add the node Output and connect a layer to it.';
    reportError(check, 'SCR017', {}, 'A recipe shows nothing by itself: it has no output.', fix);
  } else if (first === undefined) {
    reportError(check, 'SCR017', {}, 'The graph shows nothing: it has no output.', 'Add the node Output and connect a layer to it.');
  } else {
    for (const nodeId of more) {
      reportError(
        check,
        'SCR017',
        { nodeId },
        `${nodeId} is a second output beside ${first}.`,
        'Keep one of them, and combine layers with “Alpha over”.',
      );
    }
  }
}
