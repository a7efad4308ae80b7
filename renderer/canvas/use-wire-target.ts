import { useEffect } from 'react';
import { useEditor } from '../shell/editor-context.ts';
import { hoverWire } from '../state/canvas.ts';
import { canLayOver } from '../state/insert-on-wire.ts';

/** While a wire is in hand, marks the wire below the pointer where letting go there would lay one layer over the other. */
export function useWireTarget(): void {
  const editor = useEditor();
  useEffect(() => {
    const onMove = ({ clientX, clientY }: PointerEvent) => {
      const { inHand } = editor.canvas.getState();
      if (inHand !== null)
        hoverWire(
          editor.canvas,
          wireAt(clientX, clientY, (id) => canLayOver(editor, inHand, id)),
        );
    };
    window.addEventListener('pointermove', onMove);
    return () => window.removeEventListener('pointermove', onMove);
  }, [editor]);
}

/** Nodes and their ports lie over wires and hide them. */
function wireAt(x: number, y: number, accepts: (id: string) => boolean): string | null {
  const all = document.elementsFromPoint(x, y);
  if (all.some((element) => element.closest('.react-flow__node') !== null)) return null;
  for (const element of all) {
    const id = element.closest('.react-flow__edge')?.getAttribute('data-id');
    if (id !== null && id !== undefined && accepts(id)) return id;
  }
  return null;
}
