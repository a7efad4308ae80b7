import { spawn } from 'node:child_process';
import type { Socket } from 'node:net';
import process from 'node:process';
import type { Browser } from 'playwright-core';

/**
 * Shell script that ends the process group of a program, process $1, when process $2 has ended or when its own standard input closes. The
 * system closes that when the writing process ends, in whatever way it ends.
 */
const GUARD = `
end() { kill -9 -- "-$1" 2>/dev/null || kill -9 "$1" 2>/dev/null; }
if [ -n "$2" ]; then (while kill -0 "$2" 2>/dev/null; do sleep 1; done; end "$1") & fi
read -r line
end "$1"`;

/**
 * Ends a browser together with this process. Chromium ignores SIGTERM, and Playwright ends it only on signals that it can handle: not
 * SIGKILL, and none inside Jest. If `SCRIM_ENDS_WITH` is a process id, the browser also ends with that process.
 */
export async function endWithProcess(browser: Browser): Promise<void> {
  if (process.platform === 'win32') return;
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const id = processInfo.find(({ type }) => type === 'browser')?.id;
  if (id === undefined) return;
  browser.once('disconnected', endGroupWithProcess(id));
}

/**
 * Ends a process and its group together with this process, in whatever way this one ends.
 *
 * @returns Called when the process has ended by itself.
 */
export function endGroupWithProcess(id: number): () => void {
  if (process.platform === 'win32') return () => {};
  const guard = spawn('/bin/sh', ['-c', GUARD, 'sh', String(id), process.env.SCRIM_ENDS_WITH ?? ''], {
    detached: true,
    stdio: ['pipe', 'ignore', 'ignore'],
  });
  // Without a shell there is no guard.
  guard.on('error', () => {});
  guard.stdin.on('error', () => {});
  guard.unref();
  (guard.stdin as Socket).unref();
  return () => {
    const { pid, exitCode, signalCode } = guard;
    if (pid === undefined || exitCode !== null || signalCode !== null) return;
    try {
      process.kill(-pid, 'SIGKILL');
    } catch {
      // It has ended already.
    }
  };
}
