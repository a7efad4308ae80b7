import { createServer, type RequestListener, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { pipeline } from 'node:stream/promises';
import { realFolder, resolveInside } from './confine.ts';
import { refusal } from './file-errors.ts';
import { mediaTypeOf } from './media-types.ts';
import { openFile } from './read-file.ts';
import { hostCheck } from './request-checks.ts';

/** Serves exported pages on loopback, so that their author can visit them. Each page has its own port, and so its own caches. */
export interface PageServers {
  /**
   * Serves the page in a folder until `dispose`. Returns its address; the same as before if it is served already.
   *
   * @throws HostError SCR004 if the folder contains no page
   */
  serve(folder: string): Promise<string>;
  dispose(): Promise<void>;
}

const LOOPBACK = '127.0.0.1';

export function createPageServers(): PageServers {
  const servers = new Map<string, Server>();
  return {
    serve: async (folder) => {
      await checkPage(folder);
      const server = servers.get(folder) ?? (await listen());
      if (!servers.has(folder)) {
        servers.set(folder, server);
        server.on('request', hostCheck(addressOf(server), answerFrom(folder)));
      }
      return `${addressOf(server)}/`;
    },
    dispose: async () => {
      await Promise.all([...servers.values()].map(shut));
    },
  };
}

async function checkPage(folder: string): Promise<void> {
  try {
    const file = await openFile(join(folder, 'index.html'));
    await file.close();
  } catch {
    throw refusal('SCR004', `${folder} contains no page.`, 'Export the page again.');
  }
}

async function listen(): Promise<Server> {
  const server = createServer();
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(0, LOOPBACK, resolve);
  });
  return server;
}

function addressOf(server: Server): string {
  return `http://${LOOPBACK}:${(server.address() as AddressInfo).port}`;
}

/** Answers like a web host: files by name, the page at `/`. */
function answerFrom(folder: string): RequestListener {
  return async (request, response) => {
    try {
      if (request.method !== 'GET' && request.method !== 'HEAD') throw new Error('Only GET and HEAD are answered.');
      const path = decodeURIComponent((request.url ?? '/').replace(/[?#].*$/s, '')).slice(1);
      const file = await openFile(await resolveInside(await realFolder(folder), path === '' ? 'index.html' : path));
      const { size } = await file.stat();
      response.writeHead(200, {
        'content-type': mediaTypeOf(path === '' ? 'index.html' : path),
        'content-length': String(size),
        'cache-control': 'no-cache',
        'x-content-type-options': 'nosniff',
      });
      if (request.method === 'GET') await pipeline(file.createReadStream(), response);
      else {
        await file.close();
        response.end();
      }
    } catch {
      if (!response.headersSent) response.writeHead(404, { 'content-type': 'text/plain; charset=utf-8' });
      response.end('Not found.\n');
    }
  };
}

function shut(server: Server): Promise<void> {
  return new Promise((resolve) => {
    server.close(() => resolve());
    server.closeAllConnections();
  });
}
