import type { Host } from './contract.ts';
import { createHttpHost } from './http-client.ts';
import { createIpcHost, HOST_BRIDGE_NAME, type HostBridge } from './ipc-client.ts';

/** Where the loopback shell's token is kept for reloads of the page; the storage belongs to this origin, port included. */
const TOKEN_KEY = 'scrim-token';

/**
 * The host of the page the editor runs in: Electron's bridge where there is one, else the loopback server that served the page.
 * The server's address carries the launch's token behind `#`, which browsers send to nobody; it is taken out of the address bar
 * at once, so that it stays out of the history and of shared links. Returns null where the token is missing: the page was opened
 * from an address without it.
 */
export function connectHost(page: Window & typeof globalThis): Host | null {
  const bridge = (page as unknown as Partial<Record<typeof HOST_BRIDGE_NAME, HostBridge>>)[HOST_BRIDGE_NAME];
  if (bridge) return createIpcHost(bridge);
  const token = takeToken(page);
  if (token === null) return null;
  return createHttpHost({
    origin: page.location.origin,
    token,
    // Anew at each load: a page that was reloaded is another one, and what the first left unsaved is offered to it.
    client: page.crypto.randomUUID().replaceAll('-', ''),
    fetch: page.fetch.bind(page),
    waitMs: (ms) => new Promise((resolve) => page.setTimeout(resolve, ms)),
  });
}

function takeToken(page: Window): string | null {
  const fresh = new URLSearchParams(page.location.hash.slice(1)).get('token');
  if (fresh === null) return page.sessionStorage.getItem(TOKEN_KEY);
  page.sessionStorage.setItem(TOKEN_KEY, fresh);
  page.history.replaceState(page.history.state, '', page.location.pathname + page.location.search);
  return fresh;
}
