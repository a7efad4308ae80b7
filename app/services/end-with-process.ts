import { spawn } from 'node:child_process';
import type { Socket } from 'node:net';
import process from 'node:process';
import type { Browser } from 'playwright-core';

/** Ends the browser's process group when its input is closed, which the system does however the writer ends, or when process $2 is gone. */
const GUARD = `
end() { kill -9 -- "-$1" 2>/dev/null || kill -9 "$1" 2>/dev/null; }
if [ -n "$2" ]; then (while kill -0 "$2" 2>/dev/null; do sleep 1; done; end "$1") & fi
read -r line
end "$1"`;

/**
 * Makes a browser end with this process. Chromium ignores SIGTERM, and Playwright ends it only where it hears that its own process
 * ends: not of SIGKILL, and inside Jest of no signal at all. With `SCRIM_ENDS_WITH`, the id of a process, it ends with that, too.
 */
export async function endWithProcess(browser: Browser): Promise<void> {
  if (process.platform === 'win32') return;
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const id = processInfo.find(({ type }) => type === 'browser')?.id;
  if (id === undefined) return;
  const guard = spawn('/bin/sh', ['-c', GUARD, 'sh', String(id), process.env.SCRIM_ENDS_WITH ?? ''], {
    detached: true,
    stdio: ['pipe', 'ignore', 'ignore'],
  });
  // Without a shell, or once it has ended, there is no guard, and nothing to do about it.
  guard.on('error', () => {});
  guard.stdin.on('error', () => {});
  guard.unref();
  (guard.stdin as Socket).unref();
  browser.once('disconnected', () => {
    const { pid, exitCode, signalCode } = guard;
    if (pid === undefined || exitCode !== null || signalCode !== null) return;
    try {
      process.kill(-pid, 'SIGKILL');
    } catch {
      // It has ended by itself.
    }
  });
}
