import { createHash } from 'node:crypto';

/** Path beside `index.html`, because the scope of a service worker is its folder. */
export const OFFLINE_FILE = 'offline.js';

interface KeptFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

/**
 * Text of the service worker for offline use. On installation it fetches all files into a cache named by the hash of their contents; a new
 * version deletes the old cache when no page uses it. Files are named by their content, so cached ones are always valid; the page itself is
 * fetched from the network first, so that updates appear at once.
 */
export function offlineScript(index: KeptFile, files: readonly KeptFile[]): string {
  const hash = createHash('sha256');
  for (const { path, bytes } of [index, ...files]) hash.update(`${path}\n${bytes.length}\n`).update(bytes);
  const version = hash.digest('hex').slice(0, 12);
  const paths = files.map(({ path }) => path.split('/').map(encodeURIComponent).join('/'));
  return `'use strict';
const VERSION = ${JSON.stringify(version)};
const FILES = ${JSON.stringify(paths)};
${WORKER}`;
}

/** Plain JavaScript. Caches are shared by all pages of a host, so their names contain the scope. */
const WORKER = `const SCOPE = self.registration.scope;
const OWN = 'scrim ' + SCOPE + ' ';
const CACHE = OWN + VERSION;
const KEPT = new Set(FILES.map((path) => new URL(path, SCOPE).href));

self.addEventListener('install', (event) => {
  event.waitUntil(
    caches.open(CACHE).then(async (cache) => {
      await cache.addAll([...KEPT]);
      await cache.add(new Request(SCOPE, { cache: 'reload' }));
    }),
  );
});

self.addEventListener('activate', (event) => {
  event.waitUntil(
    caches.keys().then((names) => Promise.all(names.filter((name) => name.startsWith(OWN) && name !== CACHE).map((name) => caches.delete(name)))),
  );
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET') return;
  const url = new URL(request.url);
  url.hash = '';
  url.search = '';
  if (request.mode === 'navigate' && (url.href === SCOPE || url.href === SCOPE + 'index.html')) event.respondWith(openPage(request));
  else if (KEPT.has(url.href)) event.respondWith(openFile(request, url.href));
});

async function openPage(request) {
  const kept = async () => (await caches.open(CACHE)).match(SCOPE);
  try {
    const answer = await fetch(request);
    return answer.status < 500 ? answer : ((await kept()) ?? answer);
  } catch (error) {
    const page = await kept();
    if (page) return page;
    throw error;
  }
}

async function openFile(request, href) {
  const file = await (await caches.open(CACHE)).match(href);
  const range = /^bytes=(\\d+)-(\\d*)$/.exec(request.headers.get('range') ?? '');
  if (!file) return fetch(request);
  if (!range) return file;
  // Safari plays videos only if range requests are answered.
  const bytes = await file.arrayBuffer();
  const from = Number(range[1]);
  const to = Math.min(range[2] === '' ? bytes.byteLength : Number(range[2]) + 1, bytes.byteLength);
  if (from >= to) return new Response(null, { status: 416, headers: { 'content-range': 'bytes */' + bytes.byteLength } });
  return new Response(bytes.slice(from, to), {
    status: 206,
    headers: {
      'content-type': file.headers.get('content-type') ?? '',
      'content-range': 'bytes ' + from + '-' + (to - 1) + '/' + bytes.byteLength,
      'accept-ranges': 'bytes',
    },
  });
}
`;
