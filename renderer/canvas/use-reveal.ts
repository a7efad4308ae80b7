import { type Rect, useReactFlow, useStoreApi } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { Reveal } from '../state/editor/ui.ts';
import { isStill, uiScale } from '../ui/appearance.ts';

const DURATION_MS = 260;
/** Margin around a graph that fills the view, as a fraction of the view. */
export const FIT_PADDING = 0.06;

/** Scrolls nodes into view on request from outside the canvas, such as the problems panel. */
export function useReveal(): void {
  const { ui } = useEditor();
  const reveal = useStore(ui, (state) => state.reveal);
  const { fitView, getNodesBounds, setCenter } = useReactFlow();
  const store = useStoreApi();
  useEffect(() => {
    if (reveal === null) return;
    if (typeof reveal.how === 'object') {
      const { x, y, zoom } = reveal.how;
      // React Flow fits its first nodes when they arrive, which would replace the place.
      store.setState({ fitViewQueued: false });
      void setCenter(x, y, { zoom, duration: 0 });
      return;
    }
    const duration = isStill() ? 0 : DURATION_MS;
    if (reveal.how === 'fit') {
      void fitView({ ...nodesOf(reveal), padding: FIT_PADDING, maxZoom: uiScale(), duration });
      return;
    }
    const bounds = getNodesBounds([...reveal.nodes]);
    const { transform, width, height } = store.getState();
    const [x, y, zoom] = transform;
    if (bounds.width === 0 || isInside(bounds, { x: -x / zoom, y: -y / zoom, width: width / zoom, height: height / zoom })) return;
    void setCenter(bounds.x + bounds.width / 2, bounds.y + bounds.height / 2, { zoom, duration });
  }, [reveal, fitView, getNodesBounds, setCenter, store]);
}

/** Fits the graph to the canvas after a change of the dock or of the preview extent has resized the canvas. */
export function useRefit(): void {
  const { ui } = useEditor();
  const layout = useStore(ui, ({ dock, previewExtent }) => `${dock} ${previewExtent}`);
  const fitted = useRef(layout);
  const { fitView } = useReactFlow();
  const store = useStoreApi();
  useEffect(() => {
    if (layout === fitted.current) return;
    fitted.current = layout;
    const stop = store.subscribe((now, before) => {
      if (now.width === before.width && now.height === before.height) return;
      stop();
      void fitView({ padding: FIT_PADDING, maxZoom: uiScale() });
    });
    return stop;
  }, [layout, fitView, store]);
}

function nodesOf({ nodes }: Reveal): { nodes?: { id: string }[] } {
  return nodes.length === 0 ? {} : { nodes: nodes.map((id) => ({ id })) };
}

function isInside(inner: Rect, outer: Rect): boolean {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}
