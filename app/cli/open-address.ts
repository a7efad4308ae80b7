import { spawn } from 'node:child_process';
import process from 'node:process';
import { hasDisplay } from './find-electron.ts';

/** Opens an address in the default browser. Fails silently. */
export function openAddress(url: string): void {
  if (!hasDisplay()) return;
  const [command, ...args] = OPENERS[process.platform] ?? ['xdg-open'];
  const child = spawn(command as string, [...args, url], { stdio: 'ignore', detached: true });
  child.on('error', () => {});
  child.unref();
}

/** Command per platform. `start` is built into the Windows shell; its first argument is a window title. */
const OPENERS: Readonly<Partial<Record<NodeJS.Platform, readonly string[]>>> = {
  darwin: ['open'],
  win32: ['cmd', '/c', 'start', ''],
};
