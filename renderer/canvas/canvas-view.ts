import { useReactFlow, useStoreApi } from '@xyflow/react';
import { type RefObject, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { debounce } from '../clock.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';

const GRID = 8;

/**
 * Decides from each wheel event whether it comes from a mouse wheel, which zooms, or a trackpad, which pans, unless a preference says what
 * both do. The browser does not tell them apart: wheels send large equal steps along one axis, trackpads small ones along both.
 *
 * @returns Whether scrolling pans.
 */
export function useWheel(root: RefObject<HTMLElement | null>): boolean {
  const { preferences } = useEditor();
  const wheel = useStore(preferences, (state) => state.wheel);
  const [pans, setPans] = useState(false);
  useEffect(() => {
    const element = root.current;
    if (!element) return;
    const look = (event: WheelEvent) => {
      // A pinch arrives as a wheel event with Ctrl and always zooms.
      if (!event.ctrlKey) setPans(isTrackpad(event));
    };
    element.addEventListener('wheel', look, { capture: true, passive: true });
    return () => element.removeEventListener('wheel', look, { capture: true });
  }, [root]);
  return wheel === 'auto' ? pans : wheel === 'pan';
}

const WHEEL_STEP_PX = 40;

export function isTrackpad({ deltaX, deltaY, deltaMode }: Pick<WheelEvent, 'deltaX' | 'deltaY' | 'deltaMode'>): boolean {
  if (deltaMode !== 0) return false;
  return deltaX !== 0 || !Number.isInteger(deltaY) || Math.abs(deltaY) < WHEEL_STEP_PX;
}

/** When the UI scale changes, zooms the graph by the same factor about the center of the view. */
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

const PAUSE_MS = 200;

/** Tells the editor what the canvas shows, when it rests. */
export function useShownPlace(): void {
  const { canvas, clock } = useEditor();
  const store = useStoreApi();
  useEffect(() => {
    const tell = debounce(clock, PAUSE_MS, () => {
      const { transform, width, height } = store.getState();
      const [x, y, zoom] = transform;
      canvas.setState({ shown: { x: (width / 2 - x) / zoom, y: (height / 2 - y) / zoom, zoom } });
    });
    const stop = store.subscribe((now, before) => {
      if (now.transform !== before.transform) tell.trigger();
    });
    return () => {
      stop();
      tell.cancel();
    };
  }, [canvas, clock, store]);
}

/** Gives commands the center of the visible canvas, in canvas units on the grid. */
export function useCanvasCenter(root: RefObject<HTMLElement | null>, toCanvas: (client: Place) => Place): void {
  const { canvas } = useEditor();
  useEffect(() => {
    canvas.setState({
      middle: () => {
        const box = root.current?.getBoundingClientRect();
        const { x, y } = toCanvas(box ? { x: box.left + box.width / 2, y: box.top + box.height / 2 } : { x: 0, y: 0 });
        return { x: Math.round(x / GRID) * GRID, y: Math.round(y / GRID) * GRID };
      },
    });
  }, [canvas, root, toCanvas]);
}
