import { type DragEvent, useMemo, useState } from 'react';
import { stageFolder } from '../state/acquisition/stage-folder.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { addFiles } from '../state/files/add-files.ts';
import { addAssetToGraph } from '../state/files/edit-assets.ts';
import { ASSET_DRAG } from '../state/graph/place-asset.ts';
import { addFromLibrary, NODE_TYPE_DRAG } from '../state/graph/subgraph-library.ts';
import { droppedFolder } from './dropped-folder.ts';

/** Drags that begin in the editor. */
const OWN_DRAGS = [NODE_TYPE_DRAG, ASSET_DRAG];

/** Drop target of the canvas: models, images, shaders, assets of the project and nodes of the library become nodes where they are dropped.
 * A folder of photographs becomes a capture. */
export function useFileDrop(toCanvas: (client: Place) => Place) {
  const editor = useEditor();
  const [over, setOver] = useState(false);
  const handlers = useMemo(
    () => ({
      onDragOver: (event: DragEvent) => {
        const files = event.dataTransfer.types.includes('Files');
        if (!files && !OWN_DRAGS.some((type) => event.dataTransfer.types.includes(type))) return;
        event.preventDefault();
        event.dataTransfer.dropEffect = 'copy';
        setOver(files);
      },
      onDragLeave: (event: DragEvent) => {
        if (!(event.relatedTarget instanceof Node) || !event.currentTarget.contains(event.relatedTarget)) setOver(false);
      },
      onDrop: (event: DragEvent) => {
        const type = event.dataTransfer.getData(NODE_TYPE_DRAG);
        const asset = event.dataTransfer.getData(ASSET_DRAG);
        if (type === '' && asset === '' && !event.dataTransfer.types.includes('Files')) return;
        event.preventDefault();
        setOver(false);
        const folder = type === '' && asset === '' ? droppedFolder(event.dataTransfer.items) : null;
        if (folder) {
          void stageFolder(editor, folder);
          return;
        }
        const place = toCanvas({ x: event.clientX, y: event.clientY });
        if (asset !== '') void addAssetToGraph(editor, asset, place);
        else if (type === '') void addFiles(editor, [...event.dataTransfer.files], place);
        else addFromLibrary(editor, type, place);
      },
    }),
    [editor, toCanvas],
  );
  return { over, handlers };
}
