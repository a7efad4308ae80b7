import type { Host, HostEvent, HostInput, HostMethod, HostOutput } from './contract.ts';
import { type Answer, HostError, outputOf } from './host-error.ts';
import { encodeMessage, MESSAGE_TYPE } from './message.ts';

export const TOKEN_HEADER = 'x-scrim-token';
/** Carries the code of an address that opens once. */
export const CODE_HEADER = 'x-scrim-code';
/** `POST` exchanges a code for the token; `GET` says whether a token is still good. */
export const SESSION_PATH = '/api/session';
/** Tells the tabs of one browser apart. */
export const CLIENT_HEADER = 'x-scrim-client';

export interface HttpHostOptions {
  /** `http://127.0.0.1:PORT`. */
  readonly origin: string;
  /** The launch's secret. It travels in a header of our own: a cookie would reach every server on this address, whatever its port. */
  readonly token: string;
  /** Letters and digits that no other tab has. */
  readonly client: string;
  readonly fetch: typeof fetch;
  /** How long to wait before asking again for events when the connection broke. */
  readonly waitMs: (ms: number) => Promise<void>;
}

const RECONNECT_MS = 1000;

/** The host behind the loopback server. */
export function createHttpHost(options: HttpHostOptions): Host {
  return {
    call: (method, input) => call(options, method, input),
    subscribe: (listener) => {
      const stop = new AbortController();
      void listen(options, listener, stop.signal);
      return () => stop.abort();
    },
  };
}

async function call<M extends HostMethod>(options: HttpHostOptions, method: M, input: HostInput<M>): Promise<HostOutput<M>> {
  let response: Response;
  try {
    response = await options.fetch(`${options.origin}/api/call/${method}`, {
      method: 'POST',
      headers: { 'content-type': MESSAGE_TYPE, ...credentials(options) },
      body: encodeMessage(input),
    });
  } catch {
    throw new HostError({
      code: 'SCR072',
      severity: 'error',
      message: 'Scrim is not responding. Start it again in the terminal, then reload this page.',
    });
  }
  return outputOf((await response.json()) as Answer<HostOutput<M>>);
}

function credentials({ token, client }: HttpHostOptions): Record<string, string> {
  return { [TOKEN_HEADER]: token, [CLIENT_HEADER]: client };
}

/** One JSON value a line, until `signal`; asks again after a break. */
async function listen(options: HttpHostOptions, listener: (event: HostEvent) => void, signal: AbortSignal): Promise<void> {
  while (!signal.aborted) {
    try {
      const response = await options.fetch(`${options.origin}/api/events`, { headers: credentials(options), signal });
      if (response.status === 403) return;
      if (response.ok && response.body) await readLines(response.body, (line) => listener(JSON.parse(line) as HostEvent));
    } catch {
      // Broken off: the loop asks again, or ends where that was wanted.
    }
    if (!signal.aborted) await options.waitMs(RECONNECT_MS);
  }
}

async function readLines(body: ReadableStream<Uint8Array>, onLine: (line: string) => void): Promise<void> {
  const reader = body.pipeThrough(new TextDecoderStream() as ReadableWritablePair<string, Uint8Array>).getReader();
  let rest = '';
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    const lines = (rest + value).split('\n');
    rest = lines.pop() ?? '';
    // Empty lines are the server's sign of life.
    for (const line of lines) if (line !== '') onLine(line);
  }
}
