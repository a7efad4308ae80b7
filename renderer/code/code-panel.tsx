import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { shaderOf } from '../state/document/edit-shader.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { soleNode } from '../state/editor/selection.ts';
import './code-panel.css';
import { ShaderView } from './shader-view.tsx';

/** Panel with the source of the last selected node that has a shader. The source stays while nodes without a shader are selected. */
export function CodePanel() {
  const { selection } = useEditor();
  const selected = useStore(selection, soleNode);
  const [last, setLast] = useState<string | null>(null);
  const selectedHasShader = useDocument((state) => selected !== null && shaderOf(state, selected) !== null);
  useEffect(() => {
    if (selectedHasShader) setLast(selected);
  }, [selected, selectedHasShader]);

  const node = selectedHasShader ? selected : last;
  const exists = useDocument((state) => node !== null && shaderOf(state, node) !== null);
  if (node === null || !exists) return <p className="code-none">Select a filter, composite, generator or material to see its shader.</p>;
  return <ShaderView node={node} />;
}
