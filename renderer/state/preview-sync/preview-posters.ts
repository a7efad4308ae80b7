import type { ToPreview } from '../../preview-protocol.ts';
import type { Editor, ImageSize } from '../editor/editor.ts';

/** After this long, callers continue without the picture of a preview that has not drawn. A large picture may take a slow machine many seconds. */
const PATIENCE_MS = 60_000;

/** Asks the preview for pictures, and waits for them. */
export function createPosterRequests({ clock, preview }: Pick<Editor, 'clock' | 'preview'>, post: (message: ToPreview) => void) {
  let waiting: ((bytes: Uint8Array<ArrayBuffer> | null) => void) | null = null;
  let newest = 0;
  const answer = (bytes: Uint8Array<ArrayBuffer> | null) => {
    waiting?.(bytes);
    waiting = null;
  };
  return {
    /** What the preview answered; of a picture that nobody waits for any more, nothing. */
    deliver: (request: number, bytes: Uint8Array<ArrayBuffer> | null) => {
      if (request === newest) answer(bytes);
    },
    /** There is nothing to wait for any more. */
    stop: () => answer(null),
    take: ({ widthPx, heightPx }: ImageSize): Promise<Uint8Array<ArrayBuffer> | null> => {
      answer(null);
      if (!preview.getState().ready) return Promise.resolve(null);
      return new Promise((resolve) => {
        const stop = clock.after(PATIENCE_MS, () => answer(null));
        waiting = (bytes) => {
          stop();
          resolve(bytes);
        };
        newest++;
        post({ kind: 'poster', request: newest, widthPx, heightPx });
      });
    },
  };
}
