import { useReactFlow } from '@xyflow/react';
import { useEffect } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';

const DURATION_MS = 260;

/** Brings nodes into view when something outside the canvas points at them; an empty list means all. */
export function useReveal(): void {
  const { ui } = useEditor();
  const reveal = useStore(ui, (state) => state.reveal);
  const { fitView } = useReactFlow();
  useEffect(() => {
    if (reveal === null) return;
    const calm = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    const nodes = reveal.nodes.length === 0 ? {} : { nodes: reveal.nodes.map((id) => ({ id })) };
    void fitView({ ...nodes, padding: 0.2, maxZoom: 1, duration: calm ? 0 : DURATION_MS });
  }, [reveal, fitView]);
}
