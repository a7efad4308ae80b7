import { type RefObject, useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';
import { dropWire, endDrag, showResized } from '../state/canvas.ts';
import { onEscape } from '../ui/escape.ts';

/**
 * Escape gives up what the pointer is doing on the canvas: nodes go back, a wire in hand is gone, and nothing is changed. React Flow
 * has no such way, so it is told that the pointer was let go; while the returned ref says so, what it tells of that is to be ignored.
 */
export function useGiveUp(): RefObject<boolean> {
  const { canvas } = useEditor();
  const givingUp = useRef(false);
  const busy = useStore(canvas, ({ inHand, dragged, resized }) => inHand !== null || resized !== null || Object.keys(dragged).length > 0);
  useEffect(() => {
    if (!busy) return;
    return onEscape(() => {
      givingUp.current = true;
      // Both of its ways to drag, that of wires and d3's of nodes, end at this event.
      document.dispatchEvent(new MouseEvent('mouseup', { bubbles: true, view: window }));
      givingUp.current = false;
      dropWire(canvas);
      endDrag(canvas);
      showResized(canvas, null);
    });
  }, [busy, canvas]);
  return givingUp;
}
