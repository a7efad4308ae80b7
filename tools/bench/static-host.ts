import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize, sep } from 'node:path';
import { promisify } from 'node:util';
import { gzip } from 'node:zlib';

/** File types that static hosts send compressed (`compressible` in mime-db). */
const COMPRESSIBLE: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.glb': 'model/gltf-binary',
};
const OTHER: Readonly<Record<string, string>> = { '.jpg': 'image/jpeg', '.png': 'image/png' };

const compress = promisify(gzip);

export interface StaticHost {
  /** Ends in `/`. */
  readonly url: string;
  close(): Promise<void>;
}

/** Serves a folder as a static host on the internet does: text and models with gzip, on connections that stay open. */
export async function hostFolder(folder: string): Promise<StaticHost> {
  const sent = new Map<string, Promise<Buffer>>();
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname);
    const file = normalize(join(folder, path.endsWith('/') ? `${path}index.html` : path));
    const type = COMPRESSIBLE[extname(file)];
    try {
      if (!file.startsWith(normalize(folder + sep))) throw new Error('outside');
      const read = async (): Promise<Buffer> => {
        const bytes = await readFile(file);
        return type === undefined ? bytes : compress(bytes);
      };
      const body = sent.get(file) ?? read();
      sent.set(file, body);
      const encoding = type === undefined ? {} : { 'content-encoding': 'gzip' };
      const headers = { 'content-type': type ?? OTHER[extname(file)] ?? 'application/octet-stream', ...encoding };
      response.writeHead(200, { ...headers, 'content-length': (await body).length }).end(await body);
    } catch {
      sent.delete(file);
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  server.unref();
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
