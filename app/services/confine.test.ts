import { mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { HostError } from '../contract/host-error.ts';
import { realFolder, resolveInside } from './confine.ts';

let base = '';
let root = '';
beforeAll(async () => {
  base = await realFolder(await mkdtemp(join(tmpdir(), 'scrim-confine-')));
  root = join(base, 'project');
  await mkdir(join(root, 'assets', 'deep'), { recursive: true });
  await mkdir(join(base, 'secret'));
  await writeFile(join(base, 'secret', 'key.txt'), 'secret');
  await writeFile(join(root, 'assets', 'cup.glb'), 'model');
  await symlink(join(base, 'secret'), join(root, 'assets', 'link'));
  await symlink(join(base, 'secret', 'key.txt'), join(root, 'assets', 'key.txt'));
  await symlink(join(root, 'assets', 'cup.glb'), join(root, 'assets', 'own-link.glb'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

test.each(['assets/cup.glb', 'assets/deep', 'assets/not-there-yet.png', 'new/folder/file.png', 'assets/ünï cödé.png', 'assets/100%.png'])(
  'allows %s',
  async (path) => {
    expect(await resolveInside(root, path)).toBe(join(root, ...path.split('/')));
  },
);

test.each([
  ['parent', '../secret/key.txt'],
  ['parent later on', 'assets/../../secret/key.txt'],
  ['parent at the end', 'assets/..'],
  ['itself', '.'],
  ['nothing', ''],
  ['absolute', '/etc/passwd'],
  ['absolute in disguise', 'assets//etc/passwd'],
  ['drive', 'C:/Windows/win.ini'],
  ['stream', 'assets/cup.glb:hidden'],
  ['backslash', '..\\secret\\key.txt'],
  ['backslash in a name', 'assets\\cup.glb'],
  ['NUL', 'assets/cup.glb\0.png'],
  ['encoded dots', '%2e%2e/secret/key.txt'],
  ['encoded slash', 'assets%2F..%2F..%2Fsecret'],
  ['encoded backslash', '..%5Csecret'],
  ['encoded NUL', 'assets/cup.glb%00'],
  ['linked folder', 'assets/link/key.txt'],
  ['linked file', 'assets/key.txt'],
  ['link that stays inside', 'assets/own-link.glb'],
  ['new file behind a link', 'assets/link/new.txt'],
])('refuses: %s', async (_name, path) => {
  const refusal = await resolveInside(root, path).catch((error: unknown) => error);
  expect(refusal).toBeInstanceOf(HostError);
  expect((refusal as HostError).diagnostic.code).toBe('SCR031');
});

test('a project that is itself reached by a link is opened where it really lies', async () => {
  await symlink(root, join(base, 'shortcut'));
  expect(await realFolder(join(base, 'shortcut'))).toBe(root);
});
