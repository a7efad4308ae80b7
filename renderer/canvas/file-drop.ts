import { type DragEvent, useMemo, useState } from 'react';
import { useEditor } from '../shell/editor-context.ts';
import { addFiles } from '../state/add-files.ts';
import type { Place } from '../state/canvas.ts';

/** Files dragged in from outside: models, pictures and shaders become nodes where they are let go. */
export function useFileDrop(toCanvas: (client: Place) => Place) {
  const editor = useEditor();
  const [over, setOver] = useState(false);
  const handlers = useMemo(
    () => ({
      onDragOver: (event: DragEvent) => {
        if (!event.dataTransfer.types.includes('Files')) return;
        event.preventDefault();
        event.dataTransfer.dropEffect = 'copy';
        setOver(true);
      },
      onDragLeave: (event: DragEvent) => {
        if (!(event.relatedTarget instanceof Node) || !event.currentTarget.contains(event.relatedTarget)) setOver(false);
      },
      onDrop: (event: DragEvent) => {
        if (!event.dataTransfer.types.includes('Files')) return;
        event.preventDefault();
        setOver(false);
        void addFiles(editor, [...event.dataTransfer.files], toCanvas({ x: event.clientX, y: event.clientY }));
      },
    }),
    [editor, toCanvas],
  );
  return { over, handlers };
}
