import { randomBytes } from 'node:crypto';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { MAX_ASSET_BYTES } from '../../contract/call-parts.ts';
import { resolveInside } from '../../services/confine.ts';
import { passiveMediaTypeOf } from '../../services/media-types.ts';
import { readBytes } from '../../services/read-file.ts';

export interface RenderServer {
  /** URL of the page. Ends in `/` and contains a random part. */
  readonly url: string;
  /** Returns the image that the page has sent last. */
  takeImage(): Uint8Array;
  close(): Promise<void>;
}

export interface RenderServerOptions {
  readonly script: string;
  /** Real paths of folders, by their name in the URL. */
  readonly folders: Readonly<Record<string, string>>;
}

const PAGE = '<!doctype html><meta charset="utf-8"><title>Scrim</title><script src="render.js"></script>';

/** Serves the headless browser on loopback: the render page, the assets of the project, and the session. */
export async function startRenderServer({ script, folders }: RenderServerOptions): Promise<RenderServer> {
  const prefix = `/${randomBytes(16).toString('hex')}/`;
  let image: Uint8Array | null = null;

  const answer = async (request: IncomingMessage, response: ServerResponse) => {
    const [path = ''] = (request.url ?? '').split('?');
    if (!path.startsWith(prefix)) return send(response, 404, 'text/plain', 'Not found. No file or command has this address.');
    const rest = path.slice(prefix.length);
    if (request.method === 'POST' && rest === 'picture') {
      image = await readAll(request);
      return send(response, 200, 'text/plain', '');
    }
    if (rest === '') return send(response, 200, 'text/html', PAGE);
    if (rest === 'render.js') return send(response, 200, 'text/javascript', script);
    const [folder = '', ...parts] = rest.split('/').map(decodeURIComponent);
    const root = Object.hasOwn(folders, folder) ? folders[folder] : undefined;
    if (root === undefined) return send(response, 404, 'text/plain', 'Not found. No file or command has this address.');
    const file = parts.join('/');
    return send(response, 200, passiveMediaTypeOf(file), await readBytes(await resolveInside(root, file), MAX_ASSET_BYTES));
  };

  const server = createServer((request, response) => {
    answer(request, response).catch(() => send(response, 404, 'text/plain', 'Not found. No file or command has this address.'));
  });
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(0, '127.0.0.1', resolve);
  });
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}${prefix}`,
    takeImage: () => {
      if (image === null) throw new Error('The page has sent no picture.');
      return image;
    },
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

function send(response: ServerResponse, status: number, type: string, body: string | Uint8Array): void {
  response.writeHead(status, { 'content-type': `${type}`, 'cache-control': 'no-store', 'x-content-type-options': 'nosniff' }).end(body);
}

async function readAll(request: IncomingMessage): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  for await (const chunk of request as AsyncIterable<Buffer>) chunks.push(chunk);
  return Buffer.concat(chunks);
}
