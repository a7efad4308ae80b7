import { POSTER_SIZE } from '../../../app/contract/poster-size.ts';
import { setPoster } from '../../../export/graph/commands/project-info.ts';
import { apply } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { bytesOf } from './base64.ts';
import { refreshAssetFiles } from './edit-assets.ts';
import { showRefusal } from './files.ts';

/**
 * The image that an export would use as poster, as JPEG; null if the preview shows nothing.
 *
 * @param path The poster that the project has chosen, if any.
 */
export async function nextPoster(editor: Editor, path: string | undefined): Promise<Uint8Array<ArrayBuffer> | null> {
  return (await readPoster(editor, path)) ?? (await editor.posters.take?.(POSTER_SIZE)) ?? null;
}

/** A poster of the project; null without a path, or if its file is missing. */
async function readPoster({ document, host }: Editor, path: string | undefined): Promise<Uint8Array<ArrayBuffer> | null> {
  const { open } = document.getState();
  if (open === null || path === undefined) return null;
  try {
    return bytesOf((await host.call('asset.read', { handle: open.handle, path })).base64);
  } catch {
    return null;
  }
}

/** Makes the current image of the preview the poster of all exports, and says so. */
export async function keepCurrentImage(editor: Editor): Promise<void> {
  const bytes = await editor.posters.take?.(POSTER_SIZE);
  if (await keepPoster(editor, bytes ?? null)) addToast(editor.ui, { tone: 'success', text: 'Exported pages show this image as poster.' });
}

/** Makes a JPEG the poster of all exports. Returns false if that failed, or if there is none. */
export async function keepPoster(editor: Editor, bytes: Uint8Array<ArrayBuffer> | null): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null) return false;
  if (bytes === null) {
    addToast(editor.ui, { tone: 'error', text: 'There is no image for the poster.', detail: 'The preview shows nothing.' });
    return false;
  }
  try {
    const { path } = await editor.host.call('asset.import', { handle: open.handle, name: 'poster.jpg', bytes });
    void refreshAssetFiles(editor);
    return apply(editor, 'Choose the poster', setPoster(editor.document.getState().project, { path }));
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
}

/** Lets each export draw the poster from the preview. */
export function followPreview(editor: Editor): boolean {
  return apply(editor, 'Draw the poster at each export', setPoster(editor.document.getState().project, { path: null }));
}
