import { execFileSync } from 'node:child_process';
import { mkdtemp, rm, symlink, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { NotAFileError, readText, TooLargeError } from './read-file.ts';

let folder = '';
beforeEach(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-read-'));
});
afterEach(async () => {
  await stopHosts();
  await rm(folder, { recursive: true, force: true });
});

test('plain files are read; pipes, links and folders are refused without being opened, large files before a byte is read', async () => {
  const path = (name: string) => join(folder, name);
  await writeFile(path('fine'), 'fine');
  execFileSync('mkfifo', [path('pipe')]);
  await symlink(path('fine'), path('link'));
  await writeFile(path('huge'), '');
  await truncate(path('huge'), 2 ** 40);
  expect(await readText(path('fine'), 100)).toBe('fine');
  for (const name of ['pipe', 'link', '.']) await expect(readText(path(name), 100)).rejects.toThrow(NotAFileError);
  await expect(readText(path('huge'), 100)).rejects.toThrow(TooLargeError);
});

test('a pipe in the place of a project’s file keeps nobody waiting: it is named, and a save over it goes through', async () => {
  const layout = join(folder, 'project.layout.json');
  await writeFile(join(folder, 'project.scrim.json'), '{"title":"First"}\n');
  const window = openWindow(startHost(), 'a');
  const { handle, files, revision } = await window.call('project.open', { path: folder });
  execFileSync('mkfifo', [layout]);
  const named = { diagnostic: { code: 'SCR004', message: expect.stringContaining(`${layout} is a named pipe, not a file.`) } };
  await expect(window.call('project.open', { path: folder })).rejects.toMatchObject(named);
  const input = { handle, files: { ...files, layout: '{}\n' }, revision };
  await expect(window.call('project.save', { ...input, overwrite: false })).rejects.toMatchObject(named);
  await window.call('project.save', { ...input, overwrite: true });
  expect(await readText(layout, 100)).toBe('{}\n');
});
