import type { Host } from './contract.ts';
import { CODE_HEADER, createHttpHost, SESSION_PATH, TOKEN_HEADER } from './http-client.ts';
import { createIpcHost, HOST_BRIDGE_NAME, type HostBridge } from './ipc-client.ts';
import { askOtherTabs, tellOtherTabs } from './other-tabs.ts';

/** Where the loopback shell's token is kept for reloads of the page; the storage belongs to this origin, port included. */
const TOKEN_KEY = 'scrim-token';

/** `why` goes to the person: what to do to get in. */
export type Connection = { readonly host: Host } | { readonly why: string };

const NO_CODE = 'Open the address that Scrim printed when it started. Its code works once.';

/**
 * The host of the page the editor runs in: Electron's bridge where there is one, else the loopback server that served the page.
 * The server's address carries a code behind `#`, which browsers send to nobody. It is taken out of the address bar at once, so
 * that it stays out of the history and of shared links, and exchanged for the launch's token. Another tab of the same browser needs
 * no code: it gets the token from a tab that has it.
 */
export async function connectHost(page: Window & typeof globalThis): Promise<Connection> {
  const bridge = (page as unknown as Partial<Record<typeof HOST_BRIDGE_NAME, HostBridge>>)[HOST_BRIDGE_NAME];
  if (bridge) return { host: createIpcHost(bridge) };
  const found = await findToken(page);
  if ('why' in found) return found;
  const { token } = found;
  page.sessionStorage.setItem(TOKEN_KEY, token);
  tellOtherTabs(page, token);
  return {
    host: createHttpHost({
      origin: page.location.origin,
      token,
      // Anew at each load: a page that was reloaded is another one, and what the first left unsaved is offered to it.
      client: page.crypto.randomUUID().replaceAll('-', ''),
      fetch: page.fetch.bind(page),
      waitMs: (ms) => new Promise((resolve) => page.setTimeout(resolve, ms)),
    }),
  };
}

async function findToken(page: Window & typeof globalThis): Promise<{ readonly token: string } | { readonly why: string }> {
  const code = new URLSearchParams(page.location.hash.slice(1)).get('code');
  if (code !== null) {
    page.history.replaceState(page.history.state, '', page.location.pathname + page.location.search);
    return redeem(page, code);
  }
  const kept = page.sessionStorage.getItem(TOKEN_KEY);
  if (kept !== null && (await isGood(page, kept))) return { token: kept };
  const told = await askOtherTabs(page, (token) => isGood(page, token));
  return told === null ? { why: NO_CODE } : { token: told };
}

async function redeem(page: Window & typeof globalThis, code: string): Promise<{ readonly token: string } | { readonly why: string }> {
  const response = await page.fetch(SESSION_PATH, { method: 'POST', headers: { [CODE_HEADER]: code } });
  const answer = (await response.json()) as { token: string } | { diagnostic: { message: string } };
  return 'token' in answer ? answer : { why: answer.diagnostic.message };
}

async function isGood(page: Window & typeof globalThis, token: string): Promise<boolean> {
  return (await page.fetch(SESSION_PATH, { headers: { [TOKEN_HEADER]: token } })).ok;
}
