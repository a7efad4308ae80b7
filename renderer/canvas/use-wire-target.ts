import { useEffect } from 'react';
import { hoverWire } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { canCompositeOver } from '../state/graph/insert-on-wire.ts';

/** While a wire is dragged, marks the wire under the pointer if a drop would insert an Alpha over node into it. */
export function useWireTarget(): void {
  const editor = useEditor();
  useEffect(() => {
    const onMove = ({ clientX, clientY }: PointerEvent) => {
      const { draggedWire } = editor.canvas.getState();
      if (draggedWire !== null)
        hoverWire(
          editor.canvas,
          wireAt(clientX, clientY, (id) => canCompositeOver(editor, draggedWire, id)),
        );
    };
    window.addEventListener('pointermove', onMove);
    return () => window.removeEventListener('pointermove', onMove);
  }, [editor]);
}

/** Id of the topmost accepted wire at a place in client pixels; null under a node or port, which cover wires. */
function wireAt(x: number, y: number, accepts: (id: string) => boolean): string | null {
  const all = document.elementsFromPoint(x, y);
  if (all.some((element) => element.closest('.react-flow__node') !== null)) return null;
  for (const element of all) {
    const id = element.closest('.react-flow__edge')?.getAttribute('data-id');
    if (id !== null && id !== undefined && accepts(id)) return id;
  }
  return null;
}
