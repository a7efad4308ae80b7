import { type RefObject, useEffect } from 'react';
import { useEditor } from '../shell/editor-context.ts';
import type { Place } from '../state/canvas.ts';

const GRID = 8;

/** Lets commands know where the middle of what is seen is. */
export function useMiddle(root: RefObject<HTMLElement | null>, toCanvas: (client: Place) => Place): void {
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
