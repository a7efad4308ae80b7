import type { ToPreview } from '../../preview-protocol.ts';
import type { Editor, ImageSize } from '../editor/editor.ts';

/** Callers continue without a poster after this time. A large poster takes seconds on a slow machine. */
const PATIENCE_MS = 60_000;

/** Requests posters from the preview. */
export function createPosterRequests({ clock, preview }: Pick<Editor, 'clock' | 'preview'>, post: (message: ToPreview) => void) {
  let waiting: ((bytes: Uint8Array<ArrayBuffer> | null) => void) | null = null;
  let newest = 0;
  const answer = (bytes: Uint8Array<ArrayBuffer> | null) => {
    waiting?.(bytes);
    waiting = null;
  };
  return {
    /** Handles the answer of the preview. Ignores answers to older requests. */
    deliver: (request: number, bytes: Uint8Array<ArrayBuffer> | null) => {
      if (request === newest) answer(bytes);
    },
    /** Ends a pending request without a poster. */
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
