import { mkdir, mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';

const DAY_MS = 24 * 3600 * 1000;

let base = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-replaced-'));
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

const nameAt = (daysAgo: number) => `replaced-${new Date(Date.now() - daysAgo * DAY_MS).toISOString().replaceAll(':', '-')}`;

test('saving over removes what earlier saves kept for more than 30 days, except the newest five', async () => {
  const project = join(base, 'project');
  const scrim = join(project, '.scrim');
  await mkdir(scrim, { recursive: true });
  await writeFile(join(project, 'project.scrim.json'), '{"title":"First"}\n');
  const keep = async (names: readonly string[]) => {
    for (const name of names) {
      await mkdir(join(scrim, name, 'shaders'), { recursive: true });
      await writeFile(join(scrim, name, 'shaders', 'old.fs'), 'old');
    }
  };
  const saveOver = async (title: string) => {
    const window = openWindow(startHost(), 'a');
    const { handle, files, revision } = await window.call('project.open', { path: project });
    const next = { ...files, project: `{"title":"${title}"}\n` };
    const { kept } = await window.call('project.save', { handle, files: next, revision, overwrite: true });
    return kept?.replace('.scrim/', '');
  };
  const listed = async () => (await readdir(scrim)).filter((name) => name.startsWith('replaced-')).sort();

  const old = [400, 300, 200, 100].map(nameAt);
  await keep([...old, 'replaced-by-hand']);
  const first = await saveOver('Second');
  expect(await listed()).toEqual([...old, first, 'replaced-by-hand']);

  const recent = [29, 20, 10, 5, 3, 1].map(nameAt);
  await keep(recent);
  const second = await saveOver('Third');
  expect(await listed()).toEqual([...recent, first, second, 'replaced-by-hand']);
});
