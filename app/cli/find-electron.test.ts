import { mkdir, mkdtemp, rm, utimes, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { findElectron } from './find-electron.ts';

const NAMES = ['DISPLAY', 'WAYLAND_DISPLAY', 'ELECTRON_OVERRIDE_DIST_PATH', 'ELECTRON_MIRROR'] as const;
const before = Object.fromEntries(NAMES.map((name) => [name, process.env[name]]));

let root = '';
let said: string[] = [];
const say = (text: string) => said.push(text);
beforeEach(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-find-electron-'));
  said = [];
  for (const name of NAMES) delete process.env[name];
  process.env.DISPLAY = ':0';
  // Nothing listens there: the machine is offline, as far as this goes.
  process.env.ELECTRON_MIRROR = 'http://127.0.0.1:1/';
});
afterEach(async () => {
  for (const name of NAMES) {
    if (before[name] === undefined) delete process.env[name];
    else process.env[name] = before[name];
  }
  await rm(root, { recursive: true, force: true });
});

async function install(): Promise<string> {
  const folder = join(root, 'node_modules', 'electron');
  await mkdir(join(folder, 'dist'), { recursive: true });
  await writeFile(join(folder, 'package.json'), '{"version":"45.4.1"}');
  await writeFile(join(folder, 'install.js'), 'throw new Error("must not be run offline")');
  return folder;
}

(process.platform === 'linux' ? test : test.skip)('there is none without a display', async () => {
  delete process.env.DISPLAY;
  expect(await findElectron(root, say)).toEqual({ missing: 'there is no display' });
});

test('what the environment names counts, if it is there', async () => {
  const name = process.platform === 'win32' ? 'electron.exe' : 'electron';
  process.env.ELECTRON_OVERRIDE_DIST_PATH = root;
  expect(await findElectron(root, say)).toEqual({ missing: expect.stringContaining(join(root, name)) });
  await writeFile(join(root, name), '');
  expect(await findElectron(root, say)).toEqual({ path: join(root, name) });
});

test('what npm’s package has fetched is taken', async () => {
  const folder = await install();
  await writeFile(join(folder, 'path.txt'), 'electron');
  await writeFile(join(folder, 'dist', 'electron'), '');
  expect(await findElectron(root, say)).toEqual({ path: join(folder, 'dist', 'electron') });
});

test('offline, fetching is given up at once, and not tried again that day', async () => {
  await install();
  const missing = { missing: 'its program could not be fetched' };
  const start = performance.now();
  expect(await findElectron(root, say)).toEqual(missing);
  // A download may take minutes.
  expect(performance.now() - start).toBeLessThan(30_000);
  expect(said).toEqual([]);
  process.env.ELECTRON_MIRROR = 'not an address';
  expect(await findElectron(root, say)).toEqual(missing);
});

test('a day later it is tried again, and said', async () => {
  const folder = await install();
  const note = join(root, 'node_modules', '.cache', 'scrim', 'electron-45.4.1-failed');
  await mkdir(join(note, '..'), { recursive: true });
  await writeFile(note, '');
  await utimes(note, 0, 0);
  // A place that answers, and a package that then finds what it looked for.
  const { createServer } = await import('node:http');
  const server = createServer((_request, response) => response.end());
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
  process.env.ELECTRON_MIRROR = `http://127.0.0.1:${(server.address() as { port: number }).port}/`;
  const script = `const { writeFileSync } = require('fs'); const { join } = require('path');
writeFileSync(join(__dirname, 'dist', 'electron'), ''); writeFileSync(join(__dirname, 'path.txt'), 'electron');`;
  await writeFile(join(folder, 'install.js'), script);
  expect(await findElectron(root, say)).toEqual({ path: join(folder, 'dist', 'electron') });
  expect(said).toEqual([expect.stringContaining('Fetching Electron 45.4.1')]);
  await new Promise((done) => server.close(done));
});
