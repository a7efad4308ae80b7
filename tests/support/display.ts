import { type ChildProcess, spawn, spawnSync } from 'node:child_process';
import { createInterface } from 'node:readline';
import type { Readable } from 'node:stream';

export interface Display {
  /** Value for `DISPLAY`. */
  readonly name: string;
  close(): Promise<void>;
}

/** Whether a window can be opened: on the existing display, or a virtual one of Xvfb. */
export function hasDisplay(): boolean {
  if (process.platform !== 'linux' || process.env.DISPLAY) return true;
  return spawnSync('Xvfb', ['-help'], { env: process.env }).error === undefined;
}

/** Returns the existing display, or starts a virtual one until the tests end. */
export async function openDisplay(): Promise<Display> {
  const { DISPLAY } = process.env;
  if (process.platform !== 'linux' || DISPLAY) return { name: DISPLAY ?? '', close: async () => {} };
  // With `-displayfd` Xvfb chooses a free number itself, so that parallel runs do not collide.
  const child = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1600x1000x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const number = await firstLine(child);
  return { name: `:${number}`, close: () => end(child) };
}

function firstLine(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    child.once('error', reject);
    child.once('exit', (code) => reject(new Error(`Xvfb ended at once with status ${code}.`)));
    createInterface(child.stdio[3] as Readable).once('line', resolve);
  });
}

function end(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null) return Promise.resolve();
  return new Promise((resolve) => {
    child.removeAllListeners('exit');
    child.once('exit', () => resolve());
    child.kill();
  });
}
