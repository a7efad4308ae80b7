import type { FromPreview, ToPreview } from '../preview-protocol.ts';
import type { FrameRenderAnswer, FrameRenderLink } from '../state/editor/editor.ts';
import { connectPreview } from './preview-link.ts';

/** Opens a hidden preview page that renders frames or takes photographs one by one. Closing it cancels its work. */
export function openRenderPage(document: Document, previewUrl: string): FrameRenderLink {
  const frame = hiddenFrame(document, 'Frame render');
  let waiting: ((answer: FrameRenderAnswer) => void) | null = null;
  const link = connectPreview(frame, previewUrl, (message) => {
    if (!isAnswer(message)) return;
    const answer = waiting;
    waiting = null;
    answer?.(message);
  });
  return {
    ask: (message: ToPreview) =>
      new Promise((resolve) => {
        waiting = resolve;
        link.send(message);
      }),
    close: () => {
      link.dispose();
      frame.remove();
    },
  };
}

function isAnswer(message: FromPreview): message is FrameRenderAnswer {
  switch (message.kind) {
    case 'frame-rendered':
    case 'render-finished':
    case 'render-failed':
    case 'photographed':
    case 'rephotographed':
      return true;
    default:
      return false;
  }
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
