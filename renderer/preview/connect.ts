import { CONNECT_MESSAGE, type FromPreview, type ToPreview } from '../preview-protocol.ts';

export interface EditorPort {
  send(message: FromPreview, transfer?: Transferable[]): void;
  /** From now on; what came before waits. */
  listen(onMessage: (message: ToPreview) => void): void;
}

/**
 * Waits for the page that frames this one to hand over a port, and takes no other and no second: the preview can be told what to
 * play by its editor alone. Chromium says which origin the parent has.
 */
export function waitForEditor(page: Window): Promise<EditorPort> {
  return new Promise((resolve) => {
    const onMessage = (event: MessageEvent) => {
      const [port] = event.ports;
      if (event.source !== page.parent || event.source === page || event.data !== CONNECT_MESSAGE || !port) return;
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
