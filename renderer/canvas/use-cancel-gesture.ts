import { type RefObject, useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { dropWire, endDrag, showResized } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { onEscape } from '../ui/escape.ts';

/**
 * Escape cancels the gesture on the canvas: dragged nodes return, a dragged wire disappears, and the document stays as it is. React Flow
 * cannot cancel, so it gets a synthetic `mouseup`. Handlers ignore its events while the returned ref is true.
 */
export function useCancelGesture(): RefObject<boolean> {
  const { canvas } = useEditor();
  const canceling = useRef(false);
  const busy = useStore(
    canvas,
    ({ draggedWire, dragged, resized }) => draggedWire !== null || resized !== null || Object.keys(dragged).length > 0,
  );
  useEffect(() => {
    if (!busy) return;
    return onEscape(() => {
      canceling.current = true;
      // Drags of wires and of nodes (d3) both end at this event.
      document.dispatchEvent(new MouseEvent('mouseup', { bubbles: true, view: window }));
      canceling.current = false;
      dropWire(canvas);
      endDrag(canvas);
      showResized(canvas, null);
    });
  }, [busy, canvas]);
  return canceling;
}
