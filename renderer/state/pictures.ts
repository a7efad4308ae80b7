import type { ToPreview } from '../preview-protocol.ts';
import type { Editor, PictureSize } from './editor.ts';

/** Whoever waits for a preview that has not drawn by then goes on without. A large picture may take a slow machine many seconds. */
const PATIENCE_MS = 60_000;

/** Asks the preview for pictures, and waits for them. */
export function createPictures({ clock, preview }: Pick<Editor, 'clock' | 'preview'>, post: (message: ToPreview) => void) {
  let waiting: ((bytes: Uint8Array<ArrayBuffer> | null) => void) | null = null;
  const answer = (bytes: Uint8Array<ArrayBuffer> | null) => {
    waiting?.(bytes);
    waiting = null;
  };
  return {
    /** Also ends the wait where there is nothing to wait for any more. */
    answer,
    take: ({ widthPx, heightPx }: PictureSize): Promise<Uint8Array<ArrayBuffer> | null> => {
      answer(null);
      if (!preview.getState().ready) return Promise.resolve(null);
      return new Promise((resolve) => {
        const stop = clock.after(PATIENCE_MS, () => answer(null));
        waiting = (bytes) => {
          stop();
          resolve(bytes);
        };
        post({ kind: 'poster', widthPx, heightPx });
      });
    },
  };
}
