import { CONNECT_MESSAGE, type FromPreview, type ToPreview } from '../preview-protocol.ts';

/** The editor's end of the line to the preview page. */
export interface PreviewLink {
  send(message: ToPreview): void;
  dispose(): void;
}

/**
 * Hands the page in `frame` one end of a message channel, each time it has loaded. Only a page of the preview's own origin can
 * receive it: were the frame anywhere else, the browser would drop the message. What is sent earlier waits.
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

/** Of schemes of our own, too, for which `URL` may give no origin. */
function originOf(url: string): string {
  const { origin, protocol, host } = new URL(url);
  return origin === 'null' ? `${protocol}//${host}` : origin;
}
