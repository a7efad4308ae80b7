import { execFileSync } from 'node:child_process';
import { cp, mkdtemp, rm, symlink, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { scrim } from '../../tests/support/scrim.ts';
import { checkAssets } from './check-assets.ts';
import { readRephotographed } from './rephotograph/rephotograph-report.ts';

const FOLDER = 'assets/glossy-ball.capture';
let root = '';
const at = (file: string) => join(root, FOLDER, file);

beforeEach(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-check-capture-'));
  await cp(resolve('nodes/source/capture/example'), root, { recursive: true });
});
afterEach(() => rm(root, { recursive: true, force: true }));

async function said(): Promise<string[]> {
  const found = await checkAssets(root, { ball: { path: `${FOLDER}/capture.json`, kind: 'capture' } }, new Set(['ball']));
  return found.map(({ severity, code, message }) => `${severity} ${code} ${message}`);
}

test('a whole capture has no problem, also without its files of depth', async () => {
  expect(await said()).toEqual([]);
  await rm(at('depths'), { recursive: true, force: true });
  expect(await said()).toEqual([]);
});

test.each<readonly [string, (file: string) => unknown, string]>([
  ['views/003.jpg', (file) => rm(file), 'error SCR030 assets/glossy-ball.capture/views/003.jpg is missing from the project folder.'],
  ['views/003.jpg', (file) => truncate(file, 0), 'error SCR032 assets/glossy-ball.capture/views/003.jpg is empty.'],
  ['mesh.bin', (file) => rm(file), 'error SCR030 assets/glossy-ball.capture/mesh.bin is missing from the project folder.'],
  [
    'mesh.bin',
    (file) => truncate(file, 500),
    'error SCR032 assets/glossy-ball.capture/mesh.bin has 500 bytes, but capture.json says 126456.',
  ],
  [
    'capture.json',
    (file) => writeFile(file, '{}'),
    'error SCR032 assets/glossy-ball.capture/capture.json is not a valid capture: it is not a capture',
  ],
])('names a damaged %s: %#', async (file, damage, reason) => {
  await damage(at(file));
  expect(await said()).toEqual([expect.stringContaining(reason)]);
});

(process.platform === 'win32' ? test.skip : test)('does not read named pipes and links', async () => {
  await rm(at('views/003.jpg'));
  execFileSync('mkfifo', [at('views/003.jpg')]);
  expect(await said()).toEqual([`error SCR030 ${FOLDER}/views/003.jpg is a named pipe, not a file.`]);
  await rm(at('views/003.jpg'));
  await symlink('/etc/hostname', at('views/003.jpg'));
  expect(await said()).toEqual([`error SCR031 "${FOLDER}/views/003.jpg" is outside the project folder.`]);
});

test('a missing photograph ends an export and a rephotography with its name', async () => {
  await rm(at('views/003.jpg'));
  const exported = await scrim('export', root, '--out', join(root, 'site'));
  const missing = `${FOLDER}/views/003.jpg is missing from the project folder.`;
  expect(exported).toMatchObject({ status: 1, err: expect.stringContaining(`SCR030: ${missing}`) });
  // The poster is not drawn before.
  expect(exported.err).not.toContain('SCR065');
  await expect(readRephotographed(join(root, FOLDER))).rejects.toMatchObject({
    diagnostic: { code: 'SCR032', message: expect.stringContaining('views/003.jpg is missing') },
  });
});
