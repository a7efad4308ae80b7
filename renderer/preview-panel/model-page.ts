import type { DrawModel, DrawnModel } from '../state/editor/editor.ts';
import { connectPreview, type PreviewLink } from './preview-link.ts';
import { hiddenFrame } from './render-page.ts';

interface OpenPage {
  readonly frame: HTMLIFrameElement;
  readonly link: PreviewLink;
}

/** Creates what draws pictures of models, in a hidden preview page that exists while pictures are being drawn. */
export function createModelPage(document: Document, previewUrl: string): DrawModel {
  let page: OpenPage | null = null;
  let requests = 0;
  const waiting = new Map<number, (drawn: DrawnModel) => void>();
  const open = (): OpenPage => {
    const frame = hiddenFrame(document, 'Pictures of models');
    const link = connectPreview(frame, previewUrl, (message) => {
      if (message.kind !== 'model-drawn') return;
      waiting.get(message.request)?.(message);
      waiting.delete(message.request);
      if (waiting.size === 0) close();
    });
    return { frame, link };
  };
  const close = () => {
    page?.link.dispose();
    page?.frame.remove();
    page = null;
  };
  return ({ assetBaseUrl, path }, { widthPx, heightPx }) =>
    new Promise((resolve) => {
      page ??= open();
      const request = ++requests;
      waiting.set(request, resolve);
      page.link.send({ kind: 'draw-model', request, assetBaseUrl, path, widthPx, heightPx });
    });
}
