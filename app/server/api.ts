import type { IncomingMessage, ServerResponse } from 'node:http';
import type { HostDiagnostic } from '../contract/contract.ts';
import { CLIENT_HEADER, CODE_HEADER, SESSION_PATH, TOKEN_HEADER } from '../contract/http-client.ts';
import { decodeMessage, MESSAGE_TYPE } from '../contract/message.ts';
import type { HostService } from '../services/host.ts';
import { originRefusal, singleHeader } from '../services/request-checks.ts';
import type { Session } from './access-session.ts';

export interface Api {
  answer(request: IncomingMessage, response: ServerResponse): Promise<void>;
  /** Closes the event streams. */
  dispose(): void;
}

export interface ApiOptions {
  readonly host: HostService;
  readonly session: Session;
  /** Origin of the editor, the only one that may call the API. */
  readonly origin: string;
  readonly maxMessageBytes: number;
}

/** Interval of empty lines in event streams. Proxies and browsers close silent connections. */
const SIGN_OF_LIFE_MS = 15_000;

const CALL = '/api/call/';

/** Handles `POST /api/call/METHOD`, `GET /api/events` and `/api/session`; see `app/contract/http-client.ts`. */
export function createApi({ host, session, origin, maxMessageBytes }: ApiOptions): Api {
  const streams = new Set<ServerResponse>();

  const call = async (method: string, request: IncomingMessage, response: ServerResponse) => {
    if (request.headers['content-type'] !== MESSAGE_TYPE) return refuse(response, 415, 'The message is of the wrong type.');
    const body = await readBody(request, maxMessageBytes);
    if (body === null) {
      // Discards the rest of the body, because browsers read the response only after they have sent it.
      request.resume();
      return refuse(response, 413, `The message is larger than ${Math.floor(maxMessageBytes / 2 ** 20)} MB.`, 'SCR005');
    }
    let input: Record<string, unknown>;
    try {
      input = decodeMessage(body);
    } catch {
      return refuse(response, 400, 'The message is damaged.');
    }
    const answer = await host.dispatch(method, input, clientOf(request));
    send(response, 'output' in answer ? 200 : 422, answer);
  };

  const stream = (request: IncomingMessage, response: ServerResponse) => {
    response.writeHead(200, { 'content-type': 'application/x-ndjson', 'cache-control': 'no-store', 'x-content-type-options': 'nosniff' });
    response.write('\n');
    const stop = host.subscribe((event) => response.write(`${JSON.stringify(event)}\n`));
    const leave = host.attend(clientOf(request));
    const timer = setInterval(() => response.write('\n'), SIGN_OF_LIFE_MS);
    streams.add(response);
    response.on('close', () => {
      clearInterval(timer);
      stop();
      leave();
      streams.delete(response);
    });
  };

  const endStreams = () => {
    for (const response of streams) response.end();
  };
  session.ended.addEventListener('abort', endStreams);

  return {
    answer: async (request, response) => {
      const path = request.url ?? '';
      const isRedeeming = path === SESSION_PATH && request.method === 'POST';
      const refusal = originRefusal(request, origin) ?? (isRedeeming ? null : session.refusalOf(singleHeader(request, TOKEN_HEADER)));
      if (refusal !== null) return refuse(response, 403, refusal);
      if (isRedeeming) {
        const redeemed = session.redeem(singleHeader(request, CODE_HEADER));
        return 'refusal' in redeemed ? refuse(response, 403, redeemed.refusal) : send(response, 200, redeemed);
      }
      if (request.method === 'GET' && path === SESSION_PATH) return send(response, 200, {});
      if (request.method === 'GET' && path === '/api/events') return stream(request, response);
      if (request.method === 'POST' && path.startsWith(CALL)) {
        return call(path.slice(CALL.length), request, response).catch(() => void response.destroy());
      }
      return refuse(response, 404, 'Not found. No file or command has this address.');
    },
    dispose: endStreams,
  };
}

/** The id of the client. It identifies but does not authorize; the token has been checked. */
function clientOf(request: IncomingMessage): string {
  const given = request.headers[CLIENT_HEADER];
  return typeof given === 'string' ? given.slice(0, 64) : '';
}

function refuse(response: ServerResponse, status: number, message: string, code = 'SCR073'): void {
  const diagnostic: HostDiagnostic = { code, severity: 'error', message };
  send(response, status, { diagnostic });
}

function send(response: ServerResponse, status: number, value: unknown): void {
  response.writeHead(status, {
    'content-type': 'application/json',
    'cache-control': 'no-store',
    'x-content-type-options': 'nosniff',
    'cross-origin-resource-policy': 'same-origin',
  });
  response.end(JSON.stringify(value));
}

/** Reads the body of a request; null if it is larger than `maxBytes`, by its header or in fact. */
async function readBody(request: IncomingMessage, maxBytes: number): Promise<Uint8Array | null> {
  if (Number(request.headers['content-length'] ?? 0) > maxBytes) return null;
  const chunks: Buffer[] = [];
  let length = 0;
  // Destroying the stream would close the socket of the response.
  for await (const chunk of request.iterator({ destroyOnReturn: false }) as AsyncIterable<Buffer>) {
    length += chunk.length;
    if (length > maxBytes) return null;
    chunks.push(chunk);
  }
  return Buffer.concat(chunks, length);
}
