import { useReactFlow, useStoreApi } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { Reveal } from '../state/editor/ui.ts';
import { isStill, uiScale } from '../ui/appearance.ts';

const DURATION_MS = 260;
/** Margin around a graph that fills the view, as a fraction of the view. */
export const FIT_PADDING = 0.06;
/** Distance from the edge of the view to nodes that were scrolled into it, in canvas units. */
const PAN_MARGIN = 24;

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
    const seen = { x: -x / zoom, y: -y / zoom, width: width / zoom, height: height / zoom };
    const by = {
      x: shiftInto(bounds.x, bounds.width, seen.x, seen.width),
      y: shiftInto(bounds.y, bounds.height, seen.y, seen.height),
    };
    if (bounds.width === 0 || (by.x === 0 && by.y === 0)) return;
    void setCenter(seen.x + seen.width / 2 + by.x, seen.y + seen.height / 2 + by.y, { zoom, duration });
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

/**
 * How far a view has to move along an axis to show a part: not at all if it does, else until the part has a margin, or its start has one if
 * it does not fit.
 */
function shiftInto(start: number, length: number, seenStart: number, seenLength: number): number {
  if (start >= seenStart && start + length <= seenStart + seenLength) return 0;
  const toStart = start - PAN_MARGIN - seenStart;
  const toEnd = start + length + PAN_MARGIN - (seenStart + seenLength);
  return toStart < 0 ? toStart : Math.min(toStart, toEnd);
}
