/**
 * Name of the broadcast channel between the tabs of the editor. Channels belong to the origin, port included, so that the preview and other
 * sites cannot listen.
 */
const CHANNEL = 'scrim-tabs';
/** Time to wait for an answer. Open tabs answer within milliseconds. */
const ANSWER_MS = 1000;

type Message = { readonly kind: 'ask' } | { readonly kind: 'token'; readonly token: string };

/** Sends the token to tabs of the same browser that are opened later. */
export function shareToken(page: Window & typeof globalThis, token: string): void {
  const channel = new page.BroadcastChannel(CHANNEL);
  channel.onmessage = ({ data }: MessageEvent<Message>) => {
    if (data.kind === 'ask') channel.postMessage({ kind: 'token', token } satisfies Message);
  };
}

/** Asks the other tabs of this browser for a token that `isGood` accepts. Tabs of an earlier launch may send outdated ones. */
export function requestToken(page: Window & typeof globalThis, isGood: (token: string) => Promise<boolean>): Promise<string | null> {
  return new Promise((resolve) => {
    const channel = new page.BroadcastChannel(CHANNEL);
    const settle = (token: string | null) => {
      page.clearTimeout(timer);
      channel.close();
      resolve(token);
    };
    const timer = page.setTimeout(() => settle(null), ANSWER_MS);
    channel.onmessage = ({ data }: MessageEvent<Message>) => {
      if (data.kind === 'token') void isGood(data.token).then((good) => good && settle(data.token));
    };
    channel.postMessage({ kind: 'ask' } satisfies Message);
  });
}
