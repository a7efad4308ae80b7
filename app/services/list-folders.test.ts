import { mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, parse } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { listFolders } from './list-folders.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-folders-'));
  await mkdir(join(base, 'effects', 'sepia'), { recursive: true });
  await mkdir(join(base, 'effects', '.hidden'));
  await writeFile(join(base, 'effects', 'sepia', 'project.scrim.json'), '{}');
  await writeFile(join(base, 'effects', 'notes.txt'), '');
  await symlink(join(base, 'effects', 'sepia'), join(base, 'effects', 'linked'));
  await symlink(join(base, 'nowhere'), join(base, 'effects', 'broken'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

test('lists folders by name and says which are projects; neither files, nor hidden ones, nor broken links', async () => {
  const path = join(base, 'effects');
  expect(await listFolders(path)).toEqual({
    path,
    parent: base,
    folders: [
      { name: 'linked', path: join(path, 'linked'), isProject: true },
      { name: 'sepia', path: join(path, 'sepia'), isProject: true },
    ],
  });
});

test('begins at the nearest folder that exists, and ends at the root', async () => {
  expect((await listFolders(join(base, 'effects', 'new', 'deeper'))).path).toBe(join(base, 'effects'));
  expect((await listFolders(join(base, 'effects', 'notes.txt'))).path).toBe(join(base, 'effects'));
  const { root } = parse(base);
  expect(await listFolders(root)).toMatchObject({ path: root, parent: null });
  expect(dirname(root)).toBe(root);
});
