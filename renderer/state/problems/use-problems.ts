import { useEffect, useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { diagnosticWithTitles } from '../document/message-titles.ts';
import { useDocument, useEditor } from '../editor/editor-context.ts';
import type { NodeProblem } from './problems.ts';
import { collectProblems, problemsByNode, stillWrong } from './problems.ts';

/** All problems, highest severity first. While a text is being typed, new problems are delayed. */
export function useProblems(): readonly Diagnostic[] {
  const editor = useEditor();
  const load = useDocument((state) => state.loadDiagnostics);
  const compile = useStore(editor.compile, (state) => state.diagnostics);
  const preview = useStore(editor.preview, (state) => state.diagnostics);
  const driver = useStore(editor.preview, (state) => state.shaderDiagnostics);
  const exported = useStore(editor.ui, (state) => state.exportDiagnostics);
  const typing = useStore(editor.ui, (state) => state.typing);
  const all = useMemo(() => {
    const state = editor.document.getState();
    return collectProblems([load, compile, driver, preview, exported]).map((problem) => diagnosticWithTitles(state, problem));
  }, [editor, load, compile, driver, preview, exported]);
  const shown = useRef<readonly Diagnostic[]>(all);
  const problems: readonly Diagnostic[] = useMemo(() => (typing ? stillWrong(all, shown.current) : all), [typing, all]);
  useEffect(() => {
    shown.current = problems;
  }, [problems]);
  return problems;
}

/** The problems of each node. */
export function useNodeProblems(): ReadonlyMap<string, NodeProblem> {
  const problems = useProblems();
  const graph = useDocument((state) => state.graph);
  const project = useDocument((state) => state.project);
  const library = useDocument((state) => state.library);
  return useMemo(() => problemsByNode(problems, { graph, project, library }), [problems, graph, project, library]);
}
