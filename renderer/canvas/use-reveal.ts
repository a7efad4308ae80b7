import { type ReactFlowState, type Rect, useReactFlow, useStoreApi } from '@xyflow/react';
import { type RefObject, useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { Reveal } from '../state/editor/ui.ts';
import { overlaps } from '../state/graph/free-places.ts';
import { isStill, uiScale } from '../ui/appearance.ts';

const DURATION_MS = 260;
const GESTURES = ['pointerdown', 'wheel'] as const;
/** Margin around a graph that fills the view, as a fraction of the view. */
export const FIT_PADDING = 0.06;
/** Distance from the edge of the view to nodes that were scrolled into it, in canvas units. */
const PAN_MARGIN = 24;

/**
 * Scrolls nodes into view on request from outside the canvas, such as the problems panel.
 *
 * @param root The canvas, whose gestures end a move of the view.
 * @returns Starts the last move of the view again; null when it has ended.
 */
export function useReveal(root: RefObject<HTMLElement | null>): RefObject<(() => void) | null> {
  const { ui } = useEditor();
  const reveal = useStore(ui, (state) => state.reveal);
  const { fitView, getNodes, getNodesBounds, setCenter } = useReactFlow();
  const store = useStoreApi();
  const revealing = useRef<(() => void) | null>(null);
  useEffect(() => {
    if (reveal === null) return;
    const isFound = () => getNodes().some((node) => overlaps(getNodesBounds([node]), seenPart(store.getState())));
    if (reveal.how === 'find' && (getNodes().length === 0 || isFound())) return;
    const duration = isStill() ? 0 : DURATION_MS;
    const move = async (): Promise<void> => {
      if (typeof reveal.how === 'object') {
        const { x, y, zoom } = reveal.how;
        // React Flow fits its first nodes when they arrive, which would replace the place.
        store.setState({ fitViewQueued: false });
        await setCenter(x, y, { zoom, duration: 0 });
        return;
      }
      if (reveal.how !== 'show') {
        await fitView({ ...nodesOf(reveal), padding: FIT_PADDING, maxZoom: uiScale(), duration });
        return;
      }
      const bounds = getNodesBounds([...reveal.nodes]);
      const seen = seenPart(store.getState());
      const by = {
        x: shiftInto(bounds.x, bounds.width, seen.x, seen.width),
        y: shiftInto(bounds.y, bounds.height, seen.y, seen.height),
      };
      if (bounds.width === 0 || (by.x === 0 && by.y === 0)) return;
      await setCenter(seen.x + seen.width / 2 + by.x, seen.y + seen.height / 2 + by.y, { zoom: store.getState().transform[2], duration });
    };
    const start = (): void => {
      revealing.current = start;
      // React Flow starts the move after it has measured the nodes, and never resolves one that something else interrupts.
      void move().then(end);
    };
    const end = (): void => {
      if (revealing.current === start) revealing.current = null;
    };
    start();
    const canvas = root.current;
    for (const type of GESTURES) canvas?.addEventListener(type, end, { capture: true, passive: true });
    return () => {
      for (const type of GESTURES) canvas?.removeEventListener(type, end, { capture: true });
      end();
    };
  }, [reveal, root, fitView, getNodes, getNodesBounds, setCenter, store]);
  return revealing;
}

/** The part of the graph that the canvas shows, in canvas units. */
function seenPart({ transform: [x, y, zoom], width, height }: Pick<ReactFlowState, 'transform' | 'width' | 'height'>): Rect {
  return { x: -x / zoom, y: -y / zoom, width: width / zoom, height: height / zoom };
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
