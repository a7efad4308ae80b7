import { useMemo } from 'react';
import { useStore } from 'zustand';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { NodeProblem } from '../canvas/project-canvas.ts';
import { inPlainWords } from '../state/plain-words.ts';
import { collectProblems, problemsByNode } from '../state/problems.ts';
import { useDocument, useEditor } from './editor-context.ts';

/** Everything wrong, worst first. */
export function useProblems(): readonly Diagnostic[] {
  const editor = useEditor();
  const load = useDocument((state) => state.loadDiagnostics);
  const compile = useStore(editor.compile, (state) => state.diagnostics);
  const preview = useStore(editor.preview, (state) => state.diagnostics);
  const driver = useStore(editor.preview, (state) => state.shaderDiagnostics);
  const exported = useStore(editor.ui, (state) => state.exportDiagnostics);
  return useMemo(() => {
    const state = editor.document.getState();
    return collectProblems([load, compile, driver, preview, exported]).map((problem) => inPlainWords(state, problem));
  }, [editor, load, compile, driver, preview, exported]);
}

/** The same by node, as the canvas marks it. */
export function useNodeProblems(): ReadonlyMap<string, NodeProblem> {
  const problems = useProblems();
  const graph = useDocument((state) => state.graph);
  const project = useDocument((state) => state.project);
  const library = useDocument((state) => state.library);
  return useMemo(() => problemsByNode(problems, { graph, project, library }), [problems, graph, project, library]);
}
