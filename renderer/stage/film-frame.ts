import type { FromPreview, ToPreview } from '../preview-protocol.ts';
import type { FilmLink } from '../state/editor.ts';
import { connectPreview } from './preview-link.ts';

/** Another preview page, unseen, that draws frames one by one; what it was doing ends when it is closed. */
export function openFilmFrame(document: Document, previewUrl: string): FilmLink {
  const frame = document.createElement('iframe');
  frame.title = 'Frames being rendered';
  frame.tabIndex = -1;
  frame.setAttribute('aria-hidden', 'true');
  frame.referrerPolicy = 'no-referrer';
  // Not `display: none`: browsers rest such pages.
  frame.style.cssText = 'position: fixed; inset: auto auto 0 0; width: 1px; height: 1px; border: 0; opacity: 0; pointer-events: none';
  let waiting: ((answer: FromPreview) => void) | null = null;
  document.body.append(frame);
  const link = connectPreview(frame, previewUrl, (message) => {
    if (message.kind !== 'filmed' && message.kind !== 'film-over' && message.kind !== 'film-failed') return;
    waiting?.(message);
    waiting = null;
  });
  return {
    ask: (message: ToPreview) =>
      new Promise((resolve) => {
        waiting = resolve as typeof waiting;
        link.send(message);
      }),
    close: () => {
      link.dispose();
      frame.remove();
    },
  };
}
