import { CONNECT_MESSAGE, type FromPreview, type ToPreview } from '../preview-protocol.ts';

export interface EditorPort {
  send(message: FromPreview, transfer?: Transferable[]): void;
  /** Starts delivery. Earlier messages are queued until then. */
  listen(onMessage: (message: ToPreview) => void): void;
}

/**
 * Waits for the editor to transfer a MessagePort. Accepts only the first port, and only from the parent page or, in a window of its own,
 * from the page that opened the parent, so that only the editor controls the preview. In Chromium, `ancestorOrigins` verifies the origin,
 * which that window shares with the editor.
 */
export function waitForEditor(page: Window): Promise<EditorPort> {
  return new Promise((resolve) => {
    const onMessage = (event: MessageEvent) => {
      const [port] = event.ports;
      if (!isEditor(event.source, page) || event.data !== CONNECT_MESSAGE || !port) return;
      const [parentOrigin] = page.location.ancestorOrigins;
      if (parentOrigin !== undefined && event.origin !== parentOrigin) return;
      page.removeEventListener('message', onMessage);
      resolve({
        send: (message, transfer = []) => port.postMessage(message, transfer),
        listen: (listener) => {
          port.onmessage = ({ data }: MessageEvent<ToPreview>) => listener(data);
        },
      });
    };
    page.addEventListener('message', onMessage);
  });
}

function isEditor(source: MessageEventSource | null, page: Window): boolean {
  return page.parent !== page && source !== null && (source === page.parent || source === page.parent.opener);
}
