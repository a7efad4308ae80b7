import type { FromPreview, ToPreview } from '../preview-protocol.ts';
import type { FrameRenderLink } from '../state/editor/editor.ts';
import { connectPreview } from './preview-link.ts';

/** Opens a hidden preview page that renders frames one by one. Closing it cancels its work. */
export function openRenderPage(document: Document, previewUrl: string): FrameRenderLink {
  const frame = hiddenFrame(document, 'Frame render');
  let waiting: ((answer: FromPreview) => void) | null = null;
  const link = connectPreview(frame, previewUrl, (message) => {
    if (message.kind !== 'frame-rendered' && message.kind !== 'render-finished' && message.kind !== 'render-failed') return;
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

/** Adds an invisible frame to the page. */
export function hiddenFrame(document: Document, title: string): HTMLIFrameElement {
  const frame = document.createElement('iframe');
  frame.title = title;
  frame.tabIndex = -1;
  frame.setAttribute('aria-hidden', 'true');
  frame.referrerPolicy = 'no-referrer';
  // Not `display: none`, because browsers throttle such frames.
  frame.style.cssText = 'position: fixed; inset: auto auto 0 0; width: 1px; height: 1px; border: 0; opacity: 0; pointer-events: none';
  document.body.append(frame);
  return frame;
}
