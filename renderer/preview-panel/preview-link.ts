import { CONNECT_MESSAGE, type FromPreview, type ToPreview } from '../preview-protocol.ts';

/** The editor's end of the message channel to the preview page. */
export interface PreviewLink {
  send(message: ToPreview): void;
  dispose(): void;
}

/**
 * Sends the page in `frame` a port of a message channel after each load. The target origin is that of the preview, so the browser drops the
 * message if the frame shows another page. Messages sent before the load are queued.
 */
export function connectPreview(frame: HTMLIFrameElement, url: string, onMessage: (message: FromPreview) => void): PreviewLink {
  let port: MessagePort | null = null;
  let ready = false;
  let waiting: ToPreview[] = [];

  const connect = () => {
    port?.close();
    ready = false;
    const channel = new MessageChannel();
    port = channel.port1;
    port.onmessage = (event: MessageEvent<FromPreview>) => {
      if (event.data.kind === 'ready') {
        ready = true;
        for (const message of waiting) port?.postMessage(message);
        waiting = [];
      }
      onMessage(event.data);
    };
    frame.contentWindow?.postMessage(CONNECT_MESSAGE, originOf(url), [channel.port2]);
  };
  frame.addEventListener('load', connect);
  frame.src = url;

  return {
    send: (message) => {
      if (ready) port?.postMessage(message);
      else waiting.push(message);
    },
    dispose: () => {
      frame.removeEventListener('load', connect);
      port?.close();
    },
  };
}

/** Origin of a URL, also for custom schemes, for which `URL` may return none. */
function originOf(url: string): string {
  const { origin, protocol, host } = new URL(url);
  return origin === 'null' ? `${protocol}//${host}` : origin;
}
