import type { FromPreview } from '../../preview-protocol.ts';
import { stageFolder } from '../acquisition/stage-folder.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { chosenSource } from '../editor/preview-state.ts';
import { addToast, type UiStore } from '../editor/ui.ts';
import { addFiles } from '../files/add-files.ts';
import { addAssetToGraph } from '../files/edit-assets.ts';
import { floorUnder } from '../graph/floor-point.ts';
import { ASSET_DRAG } from '../graph/place-asset.ts';
import { droppedFolder } from './dropped-folder.ts';

/** Whether a drag carries files, or an asset of the project. */
export function carriesFiles({ types }: DataTransfer): boolean {
  return types.includes('Files') || types.includes(ASSET_DRAG);
}

/** Whether something that is dropped now would be added: a project is open, and no dialog covers it. */
export function takesDrops({ document, ui }: Editor): boolean {
  return document.getState().open !== null && ui.getState().dialog === null;
}

/** Adds the files that were dropped on the preview. Models stand on the floor where they were dropped. */
export function takePreviewDrop(editor: Editor, { files, hasFolder, x, y }: Extract<FromPreview, { kind: 'dropped' }>): void {
  editor.ui.setState({ fileDrags: 0 });
  if (!takesDrops(editor)) return;
  const preview = editor.preview.getState();
  // With two views, the right half shows what the left one does.
  const shownViews = chosenSource(preview)?.kind === 'room' ? preview.views : 1;
  if (hasFolder) addToast(editor.ui, { tone: 'info', text: 'Drop a folder of photographs on the graph.' });
  if (files.length > 0)
    void addFiles(editor, files, editor.canvas.getState().middle(), floorUnder(preview.status, (x * shownViews) % 1, y));
}

/** Tells the editor that files are dragged over its window. Called repeatedly while that lasts. */
export function noteFileDrag(ui: UiStore): void {
  ui.setState(({ fileDrags }) => ({ fileDrags: fileDrags + 1 }));
}

/**
 * Adds dropped files, or an asset of the project, as nodes, and a dropped folder of photographs as a capture. Call it during the event: later, what
 * was dropped is gone.
 *
 * @param place Position of the first node in canvas units. Default: the center of the visible canvas.
 */
export function takeDrop(editor: Editor, data: DataTransfer, place: Place = editor.canvas.getState().middle()): void {
  const asset = data.getData(ASSET_DRAG);
  const folder = asset === '' ? droppedFolder(data.items) : null;
  if (asset !== '') void addAssetToGraph(editor, asset, place);
  else if (folder) void stageFolder(editor, folder);
  else void addFiles(editor, [...data.files], place);
}
