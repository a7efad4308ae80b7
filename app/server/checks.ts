import { createHash, timingSafeEqual } from 'node:crypto';
import type { IncomingMessage, RequestListener } from 'node:http';
import { TOKEN_HEADER } from '../contract/http-client.ts';

/** Answers only requests that were meant for `origin`: a page whose domain was rebound to this address sends its own name. */
export function hostCheck(origin: string, listener: RequestListener): RequestListener {
  const { host } = new URL(origin);
  return (request, response) => {
    if (request.headers.host === host) listener(request, response);
    else response.writeHead(403, { 'content-type': 'text/plain; charset=utf-8' }).end(`This server answers only as ${host}.\n`);
  };
}

/** Why the request may not use the API, or null where it may. */
export function apiRefusal(request: IncomingMessage, origin: string, token: string): string | null {
  const from = request.headers.origin;
  // Browsers leave it out of same-origin GETs, and out of nothing else that can carry our header.
  if (from !== undefined ? from !== origin : request.method !== 'GET') return 'The request comes from another origin.';
  const given = request.headers[TOKEN_HEADER];
  if (typeof given !== 'string' || !sameText(given, token)) {
    return 'The token is missing or wrong. Open the address that Scrim printed in the terminal.';
  }
  return null;
}

/** Hashes have one length, so that comparing tells nothing about the secret's. */
function sameText(a: string, b: string): boolean {
  return timingSafeEqual(createHash('sha256').update(a).digest(), createHash('sha256').update(b).digest());
}
