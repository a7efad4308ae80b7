import { mkdir, mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { projectText } from '../../tests/support/project-kit.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';

let base = '';
let project = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-sessions-'));
  project = join(base, 'project');
  await mkdir(project);
  await writeFile(join(project, 'project.scrim.json'), projectText({ nodes: { 'screen-a1b2': 'output/screen' }, wires: [] }));
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

const SESSION = JSON.stringify({ format: 'scrim-session', title: 'Recording 1' });
const FILES = [
  { path: 'color/000000.jpg', bytes: 2 },
  { path: 'depth/000000.png', bytes: 3 },
];
const CONTENT = Uint8Array.of(1, 2, 3, 4, 5);

async function open(files: FileLayer = NODE_FILES) {
  const { call } = openWindow(startHost(files), 'a');
  const { handle } = await call('project.open', { path: project });
  const save = (more: object = {}) => call('session.save', { handle, session: SESSION, files: FILES, content: CONTENT, ...more });
  return { call, handle, save };
}

describe('a session that the preview has recorded', () => {
  test('becomes a folder of the project, and a preview source', async () => {
    const { call, handle, save } = await open();
    expect(await save()).toEqual({ id: 'project/recording-1' });
    const folder = join(project, 'sessions', 'recording-1');
    expect([...(await readFile(join(folder, 'color/000000.jpg')))]).toEqual([1, 2]);
    expect([...(await readFile(join(folder, 'depth/000000.png')))]).toEqual([3, 4, 5]);
    expect(await readFile(join(folder, 'session.json'), 'utf8')).toBe(SESSION);
    expect((await call('session.list', { handle }))[0]).toMatchObject({
      id: 'project/recording-1',
      title: 'Recording 1',
      kind: 'recorded',
    });
  });

  test('takes the place of no other', async () => {
    await mkdir(join(project, 'sessions', 'recording-1'), { recursive: true });
    const { save } = await open();
    expect(await save()).toEqual({ id: 'project/recording-2' });
    expect(await save()).toEqual({ id: 'project/recording-3' });
    expect(await readdir(join(project, 'sessions', 'recording-1'))).toEqual([]);
  });

  test('leaves nothing behind where the disk is full', async () => {
    let written = 0;
    const full: FileLayer = {
      ...NODE_FILES,
      writeNew: (path, bytes) => {
        if (!path.includes('sessions') || ++written < 2) return NODE_FILES.writeNew(path, bytes);
        return Promise.reject(Object.assign(new Error('No space is left.'), { code: 'ENOSPC' }));
      },
    };
    const { save } = await open(full);
    await expect(save()).rejects.toMatchObject({ diagnostic: { code: 'SCR062' } });
    expect(await readdir(join(project, 'sessions')).catch(() => [])).toEqual([]);
  });

  test('is refused where it would leave its folder, or its lengths do not add up', async () => {
    const { save } = await open();
    for (const path of ['../project.scrim.json', 'color/../../a.jpg', '/color/000000.jpg', 'session.json', 'color/000000.html']) {
      await expect(save({ files: [{ path, bytes: 5 }] })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    }
    await expect(save({ content: CONTENT.subarray(1) })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    expect(await readdir(project)).not.toContain('sessions');
    await mkdir(join(base, 'elsewhere'));
    await symlink(join(base, 'elsewhere'), join(project, 'sessions'));
    await expect(save()).rejects.toMatchObject({ diagnostic: { code: 'SCR031' } });
    expect(await readdir(join(base, 'elsewhere'))).toEqual([]);
  });
});
