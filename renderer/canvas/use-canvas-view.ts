import { useMemo } from 'react';
import { useStore } from 'zustand';
import { createEncodingLookup } from '../../export/graph/encoding-lookup.ts';
import { graphOf, layoutOf } from '../state/editor/document.ts';
import { useDocument, useEditor, useNodeTypes } from '../state/editor/editor-context.ts';
import { useNodeProblems } from '../state/problems/use-problems.ts';
import { type BorderNode, createBordersProjection } from './project-borders.ts';
import { type CanvasNode, type CanvasView, createCanvasProjection } from './project-canvas.ts';
import { createItemsProjection, type ItemNode } from './project-items.ts';
import { createReroutesProjection, type RerouteNode } from './project-reroutes.ts';

/** Everything that React Flow draws as a node. */
export type AnyNode = CanvasNode | ItemNode | RerouteNode | BorderNode;

export interface WholeView extends CanvasView {
  readonly items: readonly ItemNode[];
  readonly reroutes: readonly RerouteNode[];
  readonly borders: readonly BorderNode[];
}

/** The open graph as nodes and wires of React Flow. */
export function useCanvasView(): WholeView {
  const editor = useEditor();
  const project = useMemo(createCanvasProjection, []);
  const graph = useDocument(graphOf);
  const layout = useDocument(layoutOf);
  const library = useNodeTypes();
  const selection = useStore(editor.selection);
  const { expanded, offered, dragged, wireUnder, resized } = useStore(editor.canvas);
  const hasThumbnail = useStore(editor.preferences, (state) => state.thumbnails);
  const problems = useNodeProblems();
  const shown = useMemo(() => (offered === null ? expanded : new Set([...expanded, offered])), [expanded, offered]);
  const projectItems = useMemo(createItemsProjection, []);
  const items = useMemo(
    () => projectItems({ layout, selected: selection.items, dragged, resized }),
    [projectItems, layout, selection.items, dragged, resized],
  );
  const projectReroutes = useMemo(createReroutesProjection, []);
  const name = useDocument((state) => state.graph);
  const document = useDocument((state) => state.project);
  const reroutes = useMemo(
    () => projectReroutes({ open: { project: document, graph: name, library }, wires: graph.wires, selected: selection.items, dragged }),
    [projectReroutes, document, name, library, graph.wires, selection.items, dragged],
  );
  const { graphs, assets } = document;
  const encodings = useMemo(() => createEncodingLookup({ graphs }, library, name), [graphs, library, name]);
  const view = useMemo(
    () =>
      project({
        graph,
        layout,
        library,
        assets,
        selectedNodes: selection.nodes,
        selectedWires: selection.wires,
        expanded: shown,
        hasThumbnail,
        dragged,
        problems,
        wireUnder,
        encodings,
      }),
    [project, graph, layout, library, assets, selection, shown, hasThumbnail, dragged, problems, wireUnder, encodings],
  );
  const projectBorders = useMemo(createBordersProjection, []);
  const borders = useMemo(
    () => projectBorders({ name, graph, library, nodes: view.nodes, layout, selected: selection.items, dragged }),
    [projectBorders, name, graph, library, view.nodes, layout, selection.items, dragged],
  );
  return useMemo(
    () => ({
      ...view,
      wires: borders.wires.length === 0 ? view.wires : [...view.wires, ...borders.wires],
      items,
      reroutes,
      borders: borders.nodes,
    }),
    [view, items, reroutes, borders],
  );
}
