import { type DragEvent, useMemo, useState } from 'react';
import { carriesFiles, takeDrop, takesDrops } from '../state/drops/take-drop.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { addFromLibrary, NODE_TYPE_DRAG } from '../state/graph/subgraph-library.ts';

/** Drop target of the canvas: models, images, shaders, assets of the project and nodes of the library become nodes where they are dropped.
 * A folder of photographs becomes a capture. */
export function useFileDrop(toCanvas: (client: Place) => Place) {
  const editor = useEditor();
  const [over, setOver] = useState(false);
  const handlers = useMemo(
    () => ({
      onDragOver: (event: DragEvent) => {
        const { types } = event.dataTransfer;
        if (!takesDrops(editor) || !(carriesFiles(event.dataTransfer) || types.includes(NODE_TYPE_DRAG))) return;
        event.preventDefault();
        event.dataTransfer.dropEffect = 'copy';
        setOver(types.includes('Files'));
      },
      onDragLeave: (event: DragEvent) => {
        if (!(event.relatedTarget instanceof Node) || !event.currentTarget.contains(event.relatedTarget)) setOver(false);
      },
      onDrop: (event: DragEvent) => {
        setOver(false);
        if (!takesDrops(editor)) return;
        const place = toCanvas({ x: event.clientX, y: event.clientY });
        const type = event.dataTransfer.getData(NODE_TYPE_DRAG);
        if (type !== '') addFromLibrary(editor, type, place);
        else if (carriesFiles(event.dataTransfer)) takeDrop(editor, event.dataTransfer, place);
        else return;
        event.preventDefault();
      },
    }),
    [editor, toCanvas],
  );
  return { over, handlers };
}
