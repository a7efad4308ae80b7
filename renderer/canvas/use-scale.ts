import { useReactFlow } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';

/** Nodes grow and shrink with the text and controls around the graph, about the middle of what is seen. */
export function useScale(): void {
  const { preferences } = useEditor();
  const scale = useStore(preferences, (state) => state.scale);
  const shown = useRef(scale);
  const { getZoom, zoomTo } = useReactFlow();
  useEffect(() => {
    if (scale === shown.current) return;
    void zoomTo((getZoom() * scale) / shown.current);
    shown.current = scale;
  }, [scale, getZoom, zoomTo]);
}
