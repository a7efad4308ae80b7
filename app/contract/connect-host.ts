import type { Host } from './contract.ts';
import { CODE_HEADER, createHttpHost, SESSION_PATH, TOKEN_HEADER } from './http-client.ts';
import { createIpcHost, HOST_BRIDGE_NAME, type HostBridge } from './ipc-client.ts';
import { requestToken, shareToken } from './other-tabs.ts';

/** Session storage key of the token, for reloads of the page. Storage belongs to the origin, port included. */
const TOKEN_KEY = 'scrim-token';

/** `why`: text for the user if there is no connection. */
export type Connection = { readonly host: Host } | { readonly why: string };

const NO_CODE = 'Open the address that Scrim printed when it started. Its code works once.';

/**
 * Connects the page to its host: Electron’s bridge if it exists, else the loopback server. The address of the server contains a
 * one-time code in its fragment, which browsers do not send. The page removes it from the address bar, to keep it out of the history
 * and shared links, and exchanges it for the token of the session. Other tabs of the same browser get the token from an open tab.
 */
export async function connectHost(page: Window & typeof globalThis): Promise<Connection> {
  const bridge = (page as unknown as Partial<Record<typeof HOST_BRIDGE_NAME, HostBridge>>)[HOST_BRIDGE_NAME];
  if (bridge) return { host: createIpcHost(bridge) };
  const found = await findToken(page);
  if ('why' in found) return found;
  const { token } = found;
  page.sessionStorage.setItem(TOKEN_KEY, token);
  shareToken(page, token);
  return {
    host: createHttpHost({
      origin: page.location.origin,
      token,
      // A new id per load: unsaved changes of the page before a reload are offered for recovery.
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
    // The address begins a session: what the tab kept of an earlier one, such as its open project, no longer applies.
    page.sessionStorage.clear();
    return redeem(page, code);
  }
  const kept = page.sessionStorage.getItem(TOKEN_KEY);
  if (kept !== null && (await isGood(page, kept))) return { token: kept };
  const told = await requestToken(page, (token) => isGood(page, token));
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
