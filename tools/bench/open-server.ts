import { type ChildProcess, spawn } from 'node:child_process';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';

/** Starts the editor on loopback as `scrim open` does, and returns its address. */
export async function openServer(root: string, project: string): Promise<{ server: ChildProcess; url: string }> {
  const server = spawn(process.execPath, [join(root, 'bin', 'scrim.mjs'), 'open', project, '--browser'], {
    env: { ...process.env, DISPLAY: '', BROWSER: 'none' },
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const end = () => server.kill();
  process.once('exit', end);
  server.once('exit', () => process.off('exit', end));
  for await (const line of createInterface(server.stdout)) {
    const url = /http:\/\/127\S+/.exec(line)?.[0];
    if (url !== undefined) return { server, url };
  }
  throw new Error('The editor did not start.');
}
