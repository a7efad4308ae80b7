import { useReactFlow, useStoreApi } from '@xyflow/react';
import { type RefObject, useEffect, useRef, useState } from 'react';
import { flushSync } from 'react-dom';
import { useStore } from 'zustand';
import { debounce } from '../clock.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { zoomOf } from '../ui/appearance.ts';
import { createWheelDevice, zoomFactor } from './wheel-device.ts';

const GRID = 8;

/**
 * Applies a wheel event with Ctrl, as of a pinch, as a zoom about the pointer; other wheel events zoom or pan by the preference. `auto`:
 * a mouse wheel zooms, two fingers on a trackpad pan.
 *
 * @returns Whether scrolling pans.
 */
export function useWheel(root: RefObject<HTMLElement | null>): boolean {
  const { preferences } = useEditor();
  const wheel = useStore(preferences, (state) => state.wheel);
  const [pans, setPans] = useState(false);
  const store = useStoreApi();
  const { getViewport, setViewport } = useReactFlow();
  useEffect(() => {
    const element = root.current;
    if (!element) return;
    const device = createWheelDevice();
    const zoom = (event: WheelEvent) => {
      // React Flow zooms by a tenth for a pinch outside macOS, and the browser would zoom the whole page.
      event.preventDefault();
      event.stopPropagation();
      const box = element.getBoundingClientRect();
      const scale = zoomOf(element);
      const [atX, atY] = [(event.clientX - box.left) / scale, (event.clientY - box.top) / scale];
      const { x, y, zoom: before } = getViewport();
      const { minZoom, maxZoom } = store.getState();
      const after = Math.min(Math.max(before * zoomFactor(event), minZoom), maxZoom);
      void setViewport({ x: atX - ((atX - x) * after) / before, y: atY - ((atY - y) * after) / before, zoom: after });
    };
    const look = (event: WheelEvent) => {
      if (event.ctrlKey) zoom(event);
      // At once: this event, which React Flow gets next, counts already.
      else flushSync(() => setPans(device.isTrackpad(event)));
    };
    element.addEventListener('wheel', look, { capture: true, passive: false });
    return () => element.removeEventListener('wheel', look, { capture: true });
  }, [root, store, getViewport, setViewport]);
  return wheel === 'auto' ? pans : wheel === 'pan';
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
