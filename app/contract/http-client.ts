import type { Host, HostEvent, HostInput, HostMethod, HostOutput } from './contract.ts';
import { type Answer, HostError, outputOf } from './host-error.ts';
import { encodeMessage, MESSAGE_TYPE } from './message.ts';

export const TOKEN_HEADER = 'x-scrim-token';
/** Header with the one-time code of an address. */
export const CODE_HEADER = 'x-scrim-code';
/** `POST` exchanges a code for the token; `GET` tells whether a token is valid. */
export const SESSION_PATH = '/api/session';
/** Header that distinguishes the tabs of one browser. */
export const CLIENT_HEADER = 'x-scrim-client';

export interface HttpHostOptions {
  /** Origin such as `http://127.0.0.1:PORT`. */
  readonly origin: string;
  /** Secret of this launch. Sent in a custom header, because a cookie would reach all servers of this host, whatever their port. */
  readonly token: string;
  /** Unique id of this tab: letters and digits. */
  readonly client: string;
  readonly fetch: typeof fetch;
  /** Waits before the event stream is requested again after a lost connection. */
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

/** Reads events, one JSON value per line, until `signal` aborts. Reconnects when the connection is lost. */
async function listen(options: HttpHostOptions, listener: (event: HostEvent) => void, signal: AbortSignal): Promise<void> {
  while (!signal.aborted) {
    try {
      const response = await options.fetch(`${options.origin}/api/events`, { headers: credentials(options), signal });
      if (response.status === 403) return;
      if (response.ok && response.body) await readLines(response.body, (line) => listener(JSON.parse(line) as HostEvent));
    } catch {
      // Connection lost: the loop reconnects, or ends if it was aborted.
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
    // The server sends empty lines to keep the connection alive.
    for (const line of lines) if (line !== '') onLine(line);
  }
}
