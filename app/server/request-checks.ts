import type { IncomingMessage, RequestListener } from 'node:http';

/**
 * Answers only requests that were meant for `origin`: a page whose domain was rebound to this address sends its own name. Node
 * takes the first of several `Host` headers where a proxy may take the last, so there must be exactly one. Before HTTP/1.1 there was none.
 */
export function hostCheck(origin: string, listener: RequestListener): RequestListener {
  const { host } = new URL(origin);
  return (request, response) => {
    const given = headersNamed(request, 'host');
    if (given.length === 1 && given[0] === host && request.httpVersion === '1.1' && request.url?.startsWith('/'))
      listener(request, response);
    else {
      // What is left of the request is not waited for.
      response.writeHead(403, { 'content-type': 'text/plain; charset=utf-8', connection: 'close' });
      response.end(`This server answers only requests to ${host}.\n`);
    }
  };
}

/** Why the request does not come from the editor's own page, or null where it does. */
export function originRefusal(request: IncomingMessage, origin: string): string | null {
  const given = headersNamed(request, 'origin');
  // Browsers leave it out of same-origin GETs, and out of nothing else that can carry our headers.
  const isOurs = given.length === 0 ? request.method === 'GET' : given.length === 1 && given[0] === origin;
  return isOurs ? null : 'The request comes from another origin.';
}

/** The value of a header that is there once; empty where it is missing or there are several. */
export function singleHeader(request: IncomingMessage, name: string): string {
  const given = headersNamed(request, name);
  return given.length === 1 ? (given[0] ?? '') : '';
}

function headersNamed({ rawHeaders }: IncomingMessage, name: string): string[] {
  return rawHeaders.filter((_, i) => i % 2 === 1 && rawHeaders[i - 1]?.toLowerCase() === name);
}
