import { useStoreApi } from '@xyflow/react';
import { useEffect } from 'react';
import { hoverWire, type Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { canCompositeOver } from '../state/graph/insert-on-wire.ts';
import { nearestWire } from './nearest-wire.ts';
import { clientOf } from './use-gestures.ts';

/**
 * While a wire is dragged, marks the nearest wire if a drop would insert an Alpha over node into it. Ports come first: near one that takes
 * the dragged wire, no wire is marked.
 */
export function useWireTarget(): void {
  const editor = useEditor();
  const flow = useStoreApi();
  useEffect(() => {
    const onMove = (event: MouseEvent | TouchEvent) => {
      const { draggedWire } = editor.canvas.getState();
      if (draggedWire === null) return;
      const client = clientOf(event);
      const isFree = flow.getState().connection.isValid !== true && !isOverNode(client);
      const box = { ...client, width: 0, height: 0 };
      hoverWire(editor.canvas, isFree ? nearestWire(box, (id) => canCompositeOver(editor, draggedWire, id)) : null);
    };
    // React Flow looks for ports at the same events, on the document, which gets them before the window.
    window.addEventListener('mousemove', onMove);
    window.addEventListener('touchmove', onMove);
    return () => {
      window.removeEventListener('mousemove', onMove);
      window.removeEventListener('touchmove', onMove);
    };
  }, [editor, flow]);
}

/** Nodes cover wires. */
function isOverNode({ x, y }: Place): boolean {
  return document.elementsFromPoint(x, y).some((element) => element.closest('.react-flow__node') !== null);
}
