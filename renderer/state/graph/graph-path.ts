import { subgraphName } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { revealNodes } from '../editor/ui.ts';

/** A node, with its graph and the graphs that lead there from the main graph. */
export interface NodePlace {
  readonly graph: string;
  readonly trail: readonly string[];
  readonly node: string;
}

/** The shortest trail from the main graph to the parent of a graph. Just the main graph if the graph has no instance. */
export function pathToGraph({ graphs }: Pick<Project, 'graphs'>, graph: string): readonly string[] {
  if (graph === MAIN_GRAPH) return [];
  const ways = new Map<string, readonly string[]>([[MAIN_GRAPH, []]]);
  for (const [name, way] of ways) {
    if (name === graph) return way;
    for (const { type } of Object.values(getOwn(graphs, name)?.nodes ?? {})) {
      const inner = subgraphName(type);
      // The loop also visits added entries, so it searches breadth-first.
      if (inner !== null && !ways.has(inner)) ways.set(inner, [...way, name]);
    }
  }
  return [MAIN_GRAPH];
}

/** Finds a node by its id in the program (`look-a2b3/sepia-k7q2`). If it does not exist, the last existing node of the path. */
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

/** Opens the graph of a node, selects the node and scrolls to it. */
export function goToNode(editor: Editor, { graph, trail, node }: NodePlace): void {
  const { graph: open } = editor.document.getState();
  if (graph !== open) editor.document.setState({ graph, trail });
  selectOnly(editor.selection, [node]);
  if (graph === open) revealNodes(editor.ui, [node]);
  // The nodes of another graph must be mounted first.
  else editor.clock.nextFrame(() => revealNodes(editor.ui, [node], 'fit'));
}
