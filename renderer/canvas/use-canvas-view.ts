import { useMemo } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useNodeProblems } from '../shell/use-problems.ts';
import { graphOf, layoutOf } from '../state/document.ts';
import { type CanvasView, createCanvasProjection } from './project-canvas.ts';

/** The open graph as React Flow draws it. */
export function useCanvasView(): CanvasView {
  const editor = useEditor();
  const project = useMemo(createCanvasProjection, []);
  const graph = useDocument(graphOf);
  const layout = useDocument(layoutOf);
  const library = useDocument((state) => state.library);
  const selection = useStore(editor.selection);
  const { expanded, offered, dragged, wireUnder } = useStore(editor.canvas);
  const problems = useNodeProblems();
  const shown = useMemo(() => (offered === null ? expanded : new Set([...expanded, offered])), [expanded, offered]);
  return useMemo(
    () =>
      project({
        graph,
        layout,
        library,
        selectedNodes: selection.nodes,
        selectedWires: selection.wires,
        expanded: shown,
        dragged,
        problems,
        wireUnder,
      }),
    [project, graph, layout, library, selection, shown, dragged, problems, wireUnder],
  );
}
