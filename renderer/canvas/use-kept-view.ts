import { getViewportForBounds, useReactFlow, useStoreApi, type Viewport } from '@xyflow/react';
import { useEffect } from 'react';
import { uiScale } from '../ui/appearance.ts';
import { FIT_PADDING } from './use-reveal.ts';

/** Greatest difference of a fitted view from the computed one, in pixels and as a fraction of the zoom. */
const TOLERANCE_PX = 8;
const TOLERANCE_ZOOM = 0.02;

/** When the canvas is resized, such as by the bottom panel, a view that fits the graph fits it again; other views keep their center. */
export function useKeptView(): void {
  const store = useStoreApi();
  const { getNodes, getNodesBounds, getViewport, setViewport } = useReactFlow();
  useEffect(() => {
    let { width, height } = store.getState();
    return store.subscribe((now) => {
      // A hidden canvas has no size.
      if (now.width === 0 || now.height === 0 || (now.width === width && now.height === height)) return;
      const before = { width, height };
      ({ width, height } = now);
      if (before.width === 0 || before.height === 0) return;
      const bounds = getNodesBounds(getNodes());
      const fittedTo = (size: { readonly width: number; readonly height: number }) =>
        getViewportForBounds(bounds, size.width, size.height, now.minZoom, uiScale(), FIT_PADDING);
      const shown = getViewport();
      const centered = { ...shown, x: shown.x + (width - before.width) / 2, y: shown.y + (height - before.height) / 2 };
      void setViewport(bounds.width > 0 && isSame(shown, fittedTo(before)) ? fittedTo(now) : centered);
    });
  }, [store, getNodes, getNodesBounds, getViewport, setViewport]);
}

function isSame(a: Viewport, b: Viewport): boolean {
  return Math.hypot(a.x - b.x, a.y - b.y) <= TOLERANCE_PX && Math.abs(a.zoom / b.zoom - 1) <= TOLERANCE_ZOOM;
}
