import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize, sep } from 'node:path';

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.glb': 'model/gltf-binary',
  '.svg': 'image/svg+xml',
  '.webmanifest': 'application/manifest+json',
};

export interface StaticServer {
  readonly origin: string;
  close(): Promise<void>;
}

/**
 * A static file server like that of a web host. `mounts` maps a URL prefix ending in `/` to a folder, or a URL path to a text. The
 * longest match is used.
 */
export async function serveStatic(mounts: Readonly<Record<string, string | { text: string; type?: string }>>): Promise<StaticServer> {
  const prefixes = Object.keys(mounts).sort((a, b) => b.length - a.length);
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://x').pathname);
    const prefix = prefixes.find((p) => path === p || (p.endsWith('/') && path.startsWith(p)));
    const mount = prefix === undefined ? undefined : mounts[prefix];
    try {
      if (mount === undefined || prefix === undefined) throw new Error('no mount');
      if (typeof mount !== 'string') {
        response.writeHead(200, { 'content-type': mount.type ?? TYPES[extname(path)] ?? 'text/html; charset=utf-8' }).end(mount.text);
        return;
      }
      const relative = path.slice(prefix.length) || 'index.html';
      const file = normalize(join(mount, relative));
      if (!file.startsWith(normalize(mount + sep))) throw new Error('outside');
      const body = await readFile(file.endsWith(sep) ? join(file, 'index.html') : file);
      response.writeHead(200, { 'content-type': TYPES[extname(file) || '.html'] ?? 'application/octet-stream' }).end(body);
    } catch {
      response.writeHead(404, { 'content-type': 'text/plain' }).end(`not found: ${path}`);
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  // Keeps a server that a failed test did not close from blocking the exit of the test run.
  server.unref();
  const { port } = server.address() as AddressInfo;
  return {
    origin: `http://127.0.0.1:${port}`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
