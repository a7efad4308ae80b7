import { Readable } from 'node:stream';
import type { Protocol } from 'electron';
import { type Content, type ContentAnswer, plain } from '../services/content.ts';
import type { Origins } from '../services/content-policy.ts';

const SCHEME = 'scrim';

/**
 * Origins of editor and preview. The scheme is registered as standard and secure, so that storage, workers and WebXR work as on a web
 * server.
 */
export const ORIGINS: Origins = { editor: `${SCHEME}://editor`, preview: `${SCHEME}://preview` };

/** Registers the scheme with its privileges. Must run before the app is ready. */
export function registerScheme(protocol: Protocol): void {
  const privileges = { standard: true, secure: true, supportFetchAPI: true, stream: true };
  protocol.registerSchemesAsPrivileged([{ scheme: SCHEME, privileges }]);
}

/** Serves the scheme: by `protocol.handle` from Electron 25 on, else by `registerStreamProtocol`. */
export function serveScheme(protocol: Protocol, content: Content): void {
  if (typeof protocol.handle === 'function') {
    protocol.handle(SCHEME, async ({ method, url }) => {
      const { status, headers, body } = await answer(content, method, url);
      return new Response(Readable.toWeb(body) as ReadableStream<Uint8Array>, { status, headers });
    });
    return;
  }
  protocol.registerStreamProtocol(SCHEME, ({ method, url }, callback) => {
    void answer(content, method, url).then(({ status, headers, body }) => callback({ statusCode: status, headers, data: body }));
  });
}

/** Answers `scrim://HOST/PATH` for the hosts `editor` and `preview`; others are not found. */
export function answer(content: Content, method: string, url: string): Promise<ContentAnswer> {
  const [, origin = '', path = ''] = /^([^:]+:\/\/[^/?#]*)([^?#]*)/.exec(url) ?? [];
  const name = (['editor', 'preview'] as const).find((key) => ORIGINS[key] === origin);
  return name === undefined
    ? Promise.resolve(plain(404, 'Not found. No file or command has this address.'))
    : content.answer(name, method, path || '/');
}
