import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { shaderOf } from '../state/edit-shader.ts';
import { soleNode } from '../state/selection.ts';
import './code-panel.css';
import { ShaderView } from './shader-view.tsx';

/** The source of the shader that was last selected; it stays while other nodes are looked at. */
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
  if (node === null || !exists) return <p className="code-none">Select a filter, an operator or a generator to see its shader.</p>;
  return <ShaderView node={node} />;
}
