import { lstat, mkdir, mkdtemp, readFile, rm, utimes, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { OWNER } from '../../app/services/owner.ts';
import { isLocked, withLock } from '../../app/services/project-lock.ts';
import { openWindow, startHost, stopHosts } from '../support/host-kit.ts';
import { eventually } from '../support/patience.ts';

let project = '';
let lock = '';
beforeEach(async () => {
  project = await mkdtemp(join(tmpdir(), 'scrim-locked-'));
  lock = join(project, '.scrim', 'lock');
  await writeFile(join(project, 'project.scrim.json'), '{"title":"First"}\n');
  await mkdir(join(project, '.scrim'));
});
afterEach(async () => {
  stopHosts();
  await rm(project, { recursive: true, force: true });
});

test('a held lock does not prevent reading; it is broken when a person confirms', async () => {
  const elsewhere = OWNER.replace(/^[0-9a-f]{8}/, '00000000');
  const window = openWindow(startHost(), 'a');
  await writeFile(lock, elsewhere);
  const { handle, files, revision } = await window.call('project.open', { path: project });
  const input = { handle, files: { ...files, project: '{"title":"Two"}\n' }, revision, overwrite: false };
  await expect(window.call('project.save', input)).rejects.toMatchObject({ diagnostic: { code: 'SCR066' } });
  expect(await readFile(lock, 'utf8')).toBe(elsewhere);
  await window.call('project.break-lock', { handle });
  await window.call('project.save', input);
  expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"Two"}\n');
});

test('a long-time holder touches the lock, so that it does not count as left behind', async () => {
  await withLock(project, NODE_FILES, async ({ stillMine }) => {
    const long = new Date(Date.now() - 120_000);
    await utimes(lock, long, long);
    await eventually(async () => expect((await lstat(lock)).mtimeMs).toBeGreaterThan(long.getTime() + 60_000));
    await stillMine();
    expect(await isLocked(project, NODE_FILES)).toBe(true);
  });
  expect(await isLocked(project, NODE_FILES)).toBe(false);
});
