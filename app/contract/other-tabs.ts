/** Channels are the origin's own, port included: the preview and other sites hear nothing of it. */
const CHANNEL = 'scrim-tabs';
/** A tab that is there answers in a few milliseconds; without one, a person waits this long to be told so. */
const ANSWER_MS = 1000;

type Message = { readonly kind: 'ask' } | { readonly kind: 'token'; readonly token: string };

/** Answers the tabs of the same browser that are opened later, as long as this page lives. */
export function tellOtherTabs(page: Window & typeof globalThis, token: string): void {
  const channel = new page.BroadcastChannel(CHANNEL);
  channel.onmessage = ({ data }: MessageEvent<Message>) => {
    if (data.kind === 'ask') channel.postMessage({ kind: 'token', token } satisfies Message);
  };
}

/** The first token that another tab of this browser has and that `isGood`: a tab that was left open may have one of an earlier launch. */
export function askOtherTabs(page: Window & typeof globalThis, isGood: (token: string) => Promise<boolean>): Promise<string | null> {
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
