import type { ToPreview } from '../../preview-protocol.ts';
import type { Editor, ImageSize } from '../editor/editor.ts';
import { nodePath } from '../editor/layer-names.ts';

/** Callers continue without a poster after this time. A large poster takes seconds on a slow machine. */
const PATIENCE_MS = 60_000;

type PosterEditor = Pick<Editor, 'clock' | 'preview' | 'document' | 'selection'>;

/** Requests posters from the preview: of the framing that the project keeps, else of the selected objects. */
export function createPosterRequests(editor: PosterEditor, post: (message: ToPreview) => void) {
  const { clock, preview } = editor;
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
        post({ kind: 'poster', request: newest, widthPx, heightPx, ...subjectOf(editor) });
      });
    },
  };
}

function subjectOf({ document, selection }: PosterEditor) {
  const state = document.getState();
  const nodes = [...selection.getState().nodes].map((node) => nodePath(state, node));
  return { framing: state.project.page.framing ?? null, nodes };
}
