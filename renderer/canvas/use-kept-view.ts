import { getViewportForBounds, useReactFlow, useStoreApi, type Viewport } from '@xyflow/react';
import { type RefObject, useEffect } from 'react';
import { useEditor } from '../state/editor/editor-context.ts';
import type { UiState } from '../state/editor/ui.ts';
import { uiScale } from '../ui/appearance.ts';
import { FIT_PADDING } from './use-reveal.ts';

/** Greatest difference of a fitted view from the computed one, in pixels and as a fraction of the zoom. */
const TOLERANCE_PX = 8;
const TOLERANCE_ZOOM = 0.02;

/**
 * When the canvas is resized, such as by the bottom panel, a view that fits the graph fits it again; other views keep their center. After a
 * change of the dock or of the preview extent, every view fits the graph.
 *
 * @param revealing From `useReveal`: a resize during a move of the view starts the move again, to its end in the new size.
 */
export function useKeptView(revealing: RefObject<(() => void) | null>): void {
  const { ui } = useEditor();
  const store = useStoreApi();
  const { getNodes, getNodesBounds, getViewport, setViewport } = useReactFlow();
  useEffect(() => {
    let { width, height } = store.getState();
    let layout = layoutOf(ui.getState());
    return store.subscribe((now) => {
      // A hidden canvas has no size.
      if (now.width === 0 || now.height === 0 || (now.width === width && now.height === height)) return;
      const before = { width, height };
      ({ width, height } = now);
      const isArranged = layout !== layoutOf(ui.getState());
      layout = layoutOf(ui.getState());
      if (before.width === 0 || before.height === 0) return;
      if (revealing.current !== null) {
        revealing.current();
        return;
      }
      const bounds = getNodesBounds(getNodes());
      const fittedTo = (size: { readonly width: number; readonly height: number }) =>
        getViewportForBounds(bounds, size.width, size.height, now.minZoom, uiScale(), FIT_PADDING);
      const shown = getViewport();
      const centered = { ...shown, x: shown.x + (width - before.width) / 2, y: shown.y + (height - before.height) / 2 };
      const fits = bounds.width > 0 && (isArranged || isSame(shown, fittedTo(before)));
      void setViewport(fits ? fittedTo(now) : centered);
    });
  }, [ui, store, revealing, getNodes, getNodesBounds, getViewport, setViewport]);
}

/** What arranges the canvas and the preview. */
function layoutOf({ dock, previewExtent }: UiState): string {
  return `${dock} ${previewExtent}`;
}

function isSame(a: Viewport, b: Viewport): boolean {
  return Math.hypot(a.x - b.x, a.y - b.y) <= TOLERANCE_PX && Math.abs(a.zoom / b.zoom - 1) <= TOLERANCE_ZOOM;
}
