import type { IncomingMessage, RequestListener } from 'node:http';

/**
 * Rejects requests whose `Host` header is not that of `origin`, against DNS rebinding. The header must occur exactly once: of
 * several, Node uses the first, but a proxy may use the last. Rejects versions before HTTP/1.1, which lack it.
 */
export function hostCheck(origin: string, listener: RequestListener): RequestListener {
  const { host } = new URL(origin);
  return (request, response) => {
    const given = headersNamed(request, 'host');
    if (given.length === 1 && given[0] === host && request.httpVersion === '1.1' && request.url?.startsWith('/'))
      listener(request, response);
    else {
      // Closes the connection without reading the rest of the request.
      response.writeHead(403, { 'content-type': 'text/plain; charset=utf-8', connection: 'close' });
      response.end(`This server answers only requests to ${host}.\n`);
    }
  };
}

/** Why a request does not come from the editor’s page; null if it does. */
export function originRefusal(request: IncomingMessage, origin: string): string | null {
  const given = headersNamed(request, 'origin');
  // Browsers omit the header only in same-origin GET requests. Other requests without it cannot contain our custom headers.
  const isOurs = given.length === 0 ? request.method === 'GET' : given.length === 1 && given[0] === origin;
  return isOurs ? null : 'The request comes from another origin.';
}

/** The value of a header that occurs exactly once; else an empty string. */
export function singleHeader(request: IncomingMessage, name: string): string {
  const given = headersNamed(request, name);
  return given.length === 1 ? (given[0] ?? '') : '';
}

function headersNamed({ rawHeaders }: IncomingMessage, name: string): string[] {
  return rawHeaders.filter((_, i) => i % 2 === 1 && rawHeaders[i - 1]?.toLowerCase() === name);
}
