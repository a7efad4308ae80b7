import { type RefObject, useEffect } from 'react';
import type { Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';

const GRID = 8;

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
