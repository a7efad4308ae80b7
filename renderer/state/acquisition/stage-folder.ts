import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { isCancelled, showFailure, showProgress } from '../preview/drawn-work.ts';

/** A file of a dropped folder. */
export interface FolderFile {
  /** Path in the folder, with `/`. */
  readonly path: string;
  read(): Promise<Pick<File, 'arrayBuffer'>>;
}

/** A folder that was dropped. Its place on the disk is unknown. */
export interface DroppedFolder {
  readonly name: string;
  files(): Promise<readonly FolderFile[]>;
}

const PHOTO = /\.(jpe?g|png)$/i;
/** Files of photographs, cameras, meshes and depth. */
const USED = /\.(jpe?g|png|bin|txt|json|ply|obj|glb|gltf|exr|pfm)$/i;

/** Copies a dropped folder of photographs to the host, and opens the dialog that imports it. */
export async function stageFolder(editor: Editor, { name, files }: DroppedFolder): Promise<void> {
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return;
  const { handle } = open;
  editor.ui.setState({ exporting: { handle, text: `Reading ${name}…`, cancelled: false, frames: true } });
  try {
    const used = (await files()).filter(({ path }) => USED.test(path) && !path.split('/').some((part) => part.startsWith('.')));
    if (!used.some(({ path }) => PHOTO.test(path))) {
      addToast(editor.ui, {
        tone: 'error',
        text: `${name} has no photographs.`,
        detail: 'Drop a folder of photographs (.jpg, .png) of a place. Drop other files one by one.',
      });
      return;
    }
    let folder = '';
    for (const [index, { path, read }] of used.entries()) {
      if (isCancelled(editor)) return;
      showProgress(editor, `Copying ${index + 1} of ${used.length} files…`);
      const bytes = new Uint8Array(await (await read()).arrayBuffer());
      folder = (await editor.host.call('photographs.stage', { handle, folder: name, path, bytes, first: index === 0 })).folder;
    }
    if (editor.document.getState().open?.handle === handle) editor.ui.setState({ dialog: { kind: 'photographs', folder } });
  } catch (error) {
    if (error instanceof DOMException) addToast(editor.ui, { tone: 'error', text: `${name} cannot be read: ${error.message}` });
    else showFailure(editor, error);
  } finally {
    editor.ui.setState({ exporting: null });
  }
}
