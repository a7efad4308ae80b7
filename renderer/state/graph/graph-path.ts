import { subgraphName } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { revealNodes } from '../editor/ui.ts';

/** A node, and the graphs that lead to its own from the main graph. */
export interface NodePlace {
  readonly graph: string;
  readonly trail: readonly string[];
  readonly node: string;
}

/** The shortest way from the main graph to another, without that; of one that no node stands for, just the main graph. */
export function pathToGraph({ graphs }: Pick<Project, 'graphs'>, graph: string): readonly string[] {
  if (graph === MAIN_GRAPH) return [];
  const ways = new Map<string, readonly string[]>([[MAIN_GRAPH, []]]);
  for (const [name, way] of ways) {
    if (name === graph) return way;
    for (const { type } of Object.values(getOwn(graphs, name)?.nodes ?? {})) {
      const inner = subgraphName(type);
      // A map is gone through with what is added to it meanwhile, so the nearest come first.
      if (inner !== null && !ways.has(inner)) ways.set(inner, [...way, name]);
    }
  }
  return [MAIN_GRAPH];
}

/** Where the node is that the compiler calls `look-a2b3/sepia-k7q2`, or the last on the way to it that is there. */
export function placeOnPath({ graphs }: Pick<Project, 'graphs'>, path: string): NodePlace | null {
  let place: NodePlace | null = null;
  let graph: string | null = MAIN_GRAPH;
  let trail: readonly string[] = [];
  for (const node of path.split('/')) {
    const found: { readonly type: string } | undefined = graph === null ? undefined : getOwn(getOwn(graphs, graph)?.nodes ?? {}, node);
    if (graph === null || !found) break;
    place = { graph, trail, node };
    trail = [...trail, graph];
    graph = subgraphName(found.type);
  }
  return place;
}

/** Opens the graph that it is in, selects it and shows it. */
export function goToNode(editor: Editor, { graph, trail, node }: NodePlace): void {
  const { graph: open } = editor.document.getState();
  if (graph !== open) editor.document.setState({ graph, trail });
  selectOnly(editor.selection, [node]);
  if (graph === open) revealNodes(editor.ui, [node]);
  // The nodes of another graph have to be on the canvas before they can be shown.
  else editor.clock.nextFrame(() => revealNodes(editor.ui, [node], 'fit'));
}
