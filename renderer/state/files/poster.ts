import { POSTER_SIZE } from '../../../app/contract/poster-size.ts';
import { setFraming, setPoster } from '../../../export/graph/commands/project-info.ts';
import { framingOf, type PosterFraming, type ViewCrop } from '../../../nodes/kit/poster-framing.ts';
import type { PreviewStatus } from '../../preview-protocol.ts';
import { apply } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { type ChosenSource, chosenSource, type PreviewState } from '../editor/preview-state.ts';
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

/** Lets each export draw the poster: of the framing that the project keeps, else of the objects. */
export function followPreview(editor: Editor): boolean {
  return apply(editor, 'Draw the poster at each export', setPoster(editor.document.getState().project, { path: null }));
}

/** Lets each export draw the poster of the objects. */
export function frameObjects(editor: Editor): boolean {
  return apply(editor, 'Frame the objects in the poster', setFraming(editor.document.getState().project, { framing: null }));
}

/** Lets each export draw the poster of this part of the first view, as the preview shows it. */
export function keepFraming(editor: Editor, crop: ViewCrop, { tangents, worldFromView }: PreviewStatus): void {
  if (!tangents) return;
  const { center, height } = framingOf(crop, tangents);
  const room = roomOf(editor, worldFromView);
  const framing: PosterFraming = { center: [round(center[0]), round(center[1])], height: round(height), ...(room && { room }) };
  if (apply(editor, 'Frame the poster', setFraming(editor.document.getState().project, { framing })))
    addToast(editor.ui, { tone: 'success', text: 'Exports draw the poster as framed.' });
}

/** The source that shows the room of a framing; null if the framing has no room, or if the preview shows it. */
export function roomToShow(state: PreviewState, framing: PosterFraming | undefined): ChosenSource | null {
  const id = framing?.room ? `${ROOM_PREFIX}${framing.room.name}` : null;
  return chosenSource(state)?.id === id ? null : (state.sources.find((source) => source.id === id) ?? null);
}

const ROOM_PREFIX = 'room/';

/** Where the head stands, if the preview shows an emulated room. */
function roomOf({ preview }: Editor, pose: readonly number[] | null): PosterFraming['room'] | null {
  const id = chosenSource(preview.getState())?.id ?? '';
  if (!id.startsWith(ROOM_PREFIX) || !pose) return null;
  const [x = 0, y = 0, z = 0] = pose.slice(12);
  const [backX = 0, backY = 0, backZ = 0] = pose.slice(8);
  const eye = [round(x), round(y), round(z)] as const;
  return { name: id.slice(ROOM_PREFIX.length), eye, target: [round(x - backX), round(y - backY), round(z - backZ)] };
}

/** Four decimals: a tenth of a millimeter. */
function round(value: number): number {
  return Number(value.toFixed(4));
}
