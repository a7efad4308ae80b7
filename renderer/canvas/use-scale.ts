import { useReactFlow } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';

/** Zooms the graph with the UI scale, about the center of the view. */
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
