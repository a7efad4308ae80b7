import { sequence } from '../../../export/graph/commands/change.ts';
import { removeGraph, usersOfGraph } from '../../../export/graph/commands/subgraph-commands.ts';
import { ungroupSubgraph } from '../../../export/graph/commands/ungroup-subgraph.ts';
import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { titleOfName } from '../editor/library.ts';
import { addToast } from '../editor/ui.ts';
import { addNodeFromPalette } from './edit-graph.ts';
import { titleOfGraph } from './find.ts';
import { nameOfTitle, renameSubgraph } from './subgraphs.ts';

/** Data transfer type of a node that is dragged from the library. */
export const NODE_TYPE_DRAG = 'application/x-scrim-node-type';

/** Names of the project’s subgraphs in alphabetical order. */
export function librarySubgraphs({ graphs }: Pick<Project, 'graphs'>): readonly string[] {
  return Object.keys(graphs)
    .filter((name) => name !== MAIN_GRAPH)
    .sort();
}

/** Number of instances of a subgraph, by graph. */
export function usesOfSubgraph(project: Project, name: string): readonly { readonly graph: string; readonly nodes: number }[] {
  const counts = new Map<string, number>();
  for (const [graph] of usersOfGraph(project, name)) counts.set(graph, (counts.get(graph) ?? 0) + 1);
  return [...counts].map(([graph, nodes]) => ({ graph, nodes }));
}

/** Text such as `2 nodes in the main graph and 1 node in “Glow”`; null if the subgraph is not used. */
export function usesInWords(project: Project, name: string): string | null {
  const parts = usesOfSubgraph(project, name).map(({ graph, nodes }) => {
    const where = graph === MAIN_GRAPH ? 'the main graph' : `“${titleOfGraph(graph)}”`;
    return `${nodes} ${nodes === 1 ? 'node' : 'nodes'} in ${where}`;
  });
  return parts.length === 0 ? null : [parts.slice(0, -1).join(', '), parts.at(-1)].filter(Boolean).join(' and ');
}

/** Why a subgraph cannot have a title; null if it can. */
export function titleProblem({ graphs }: Pick<Project, 'graphs'>, name: string, title: string): string | null {
  const wanted = nameOfTitle(title);
  if (wanted === '') return 'The name must begin with a letter.';
  return wanted !== name && getOwn(graphs, wanted) !== undefined ? 'The project already has a subgraph of this name.' : null;
}

/** Renames a subgraph to the title under which the node search finds it. */
export function saveToLibrary(editor: Editor, name: string, title: string): boolean {
  if (!renameSubgraph(editor, name, title)) return false;
  addToast(editor.ui, {
    tone: 'success',
    text: `Saved “${titleOfName(nameOfTitle(title))}” to the library of this project.`,
    detail: 'The node search finds it. Edits apply to all of its instances.',
  });
  return true;
}

/** Adds an instance of a subgraph to the open graph. */
export function addFromLibrary(editor: Editor, type: string, place: Place): string | null {
  const definition = editor.document.getState().library.definition(type);
  return definition === undefined ? null : addNodeFromPalette(editor, { definition, port: null }, place, null);
}

/**
 * Removes a subgraph from the library. Its instances are replaced by their contents, so that the output does not change. One undo
 * step.
 */
export function removeFromLibrary(editor: Editor, name: string): boolean {
  const { project } = editor.document.getState();
  const unpack = usersOfGraph(project, name).map(
    ([graph, node]) =>
      (before: Project) =>
        ungroupSubgraph(before, { library: editor.libraries.of(before), graph, node, random: editor.random }),
  );
  const removed = sequence(project, ...unpack, (before) => removeGraph(before, { name }));
  return apply(editor, `Remove ${titleOfName(name)} from the library`, removed);
}
