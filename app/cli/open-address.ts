import { spawn } from 'node:child_process';
import process from 'node:process';
import { hasDisplay } from './find-electron.ts';

/** Shows an address in the person's browser where that is possible, and is silent where it is not. */
export function openAddress(url: string): void {
  if (!hasDisplay()) return;
  const [command, ...args] = OPENERS[process.platform] ?? ['xdg-open'];
  const child = spawn(command as string, [...args, url], { stdio: 'ignore', detached: true });
  child.on('error', () => {});
  child.unref();
}

/** `start` is a word of the shell; its first argument is a title. */
const OPENERS: Readonly<Partial<Record<NodeJS.Platform, readonly string[]>>> = {
  darwin: ['open'],
  win32: ['cmd', '/c', 'start', ''],
};
