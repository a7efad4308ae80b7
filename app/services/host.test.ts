import { mkdir, mkdtemp, readdir, readFile, rename, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';

let base = '';
let project = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-asked-'));
  project = join(base, 'project');
  await mkdir(project);
  await writeFile(join(project, 'project.scrim.json'), '{"title":"First"}\n');
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

describe('what a page may not ask of the host', () => {
  test('texts larger than any project has', async () => {
    const window = openWindow(startHost(), 'a');
    const { handle, files, revision } = await window.call('project.open', { path: project });
    const huge = 'x'.repeat(64 * 2 ** 20 + 1);
    for (const tooMuch of [
      { ...files, project: huge },
      { ...files, layout: huge },
      { ...files, sources: { 'a.fs': huge } },
    ]) {
      const save = window.call('project.save', { handle, files: tooMuch, revision, overwrite: true });
      await expect(save).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    }
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe(files.project);
  });

  test('a folder by a path that begins nowhere', async () => {
    const window = openWindow(startHost(), 'a');
    const { handle, files } = await window.call('project.open', { path: project });
    for (const path of ['mine', './mine', '../mine', 'C:mine']) {
      await expect(window.call('project.open', { path })).rejects.toMatchObject({ diagnostic: { code: 'SCR004' } });
      for (const asked of [
        window.call('project.create', { path, template: 'empty' }),
        window.call('project.save-as', { handle, path, files }),
        window.call('export.run', { handle, files, out: path }),
      ]) {
        await expect(asked).rejects.toMatchObject({ diagnostic: { code: 'SCR060' } });
      }
    }
  });

  test('a project that cannot be opened to the end, which nobody shows then', async () => {
    const own = join(project, '.scrim');
    const moved = join(base, 'moved');
    const files: FileLayer = {
      ...NODE_FILES,
      writeNew: async (path, bytes) => {
        await NODE_FILES.writeNew(path, bytes);
        if (!basename(path).startsWith('window-')) return;
        await rename(own, moved);
        await symlink(moved, own);
      },
    };
    const window = openWindow(startHost(files), 'a');
    await expect(window.call('project.open', { path: project })).rejects.toMatchObject({ diagnostic: { code: 'SCR031' } });
    expect((await readdir(moved)).filter((name) => name.startsWith('window-'))).toEqual([]);
  });

  test('a template that is none, or leads elsewhere', async () => {
    const window = openWindow(startHost(), 'a');
    for (const template of ['none', '../first-light', '/etc', '.']) {
      const asked = window.call('project.create', { path: join(base, 'new'), template });
      await expect(asked).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    }
    expect(await readdir(base)).toEqual(['project']);
  });
});

test('files in `assets/` that could not be read by their names, which are left out', async () => {
  const window = openWindow(startHost(), 'a');
  for (const path of ['a:b/cup.glb', 'fine/a:b.glb', 'fine/%2e.glb', 'fine/cup.glb']) {
    await mkdir(join(project, 'assets', dirname(path)), { recursive: true });
    await writeFile(join(project, 'assets', path), 'glTF');
  }
  const { handle, files, assetFiles } = await window.call('project.open', { path: project });
  expect(assetFiles).toEqual([{ path: 'assets/fine/cup.glb', bytes: 4 }]);
  const { displayPath } = await window.call('project.save-as', { handle, path: join(base, 'second'), files });
  expect(await readdir(join(displayPath, 'assets'), { recursive: true })).toEqual(['fine', join('fine', 'cup.glb')]);
});

test('a host that stops writes nothing afterward: it waits for the calls in progress', async () => {
  let goOn = () => {};
  const mayWrite = new Promise<void>((resolve) => {
    goOn = resolve;
  });
  const slow: FileLayer = {
    ...NODE_FILES,
    rename: async (from, to) => {
      await mayWrite;
      await NODE_FILES.rename(from, to);
    },
  };
  const host = startHost(slow);
  const window = openWindow(host, 'a');
  const { handle, files } = await window.call('project.open', { path: project });
  const autosave = window.call('project.autosave', { handle, files: { ...files, project: '{"title":"Second"}\n' } });
  let hasStopped = false;
  const stop = host.dispose().then(() => {
    hasStopped = true;
  });
  await new Promise((resolve) => setTimeout(resolve, 50));
  expect(hasStopped).toBe(false);
  goOn();
  await stop;
  expect((await readdir(join(project, '.scrim'))).filter((name) => name.startsWith('unsaved-'))).toHaveLength(1);
  await autosave;
});

describe('a new project', () => {
  test('is made in a folder of the person’s choice, and open', async () => {
    const host = startHost();
    const window = openWindow(host, 'a');
    const { templates } = await window.call('app.info', {});
    expect(templates.map(({ name }) => name)).toEqual(['empty', 'filter', 'occlusion']);
    const path = join(base, 'shows', 'Tin robot');
    const opened = await window.call('project.create', { path, template: 'occlusion' });
    expect(JSON.parse(opened.files.project)).toMatchObject({ title: 'Tin robot' });
    const named = await window.call('project.create', { path: `${path}-2`, template: 'empty', title: 'Robot: Größe 2/3' });
    expect(JSON.parse(named.files.project)).toMatchObject({ title: 'Robot: Größe 2/3' });
    // Templates describe themselves, not the pages that are made of them.
    expect(templates.find(({ name }) => name === 'occlusion')?.description).toMatch(/shadow/);
    expect(JSON.parse(opened.files.project)).not.toHaveProperty('page');
    expect(opened.assetFiles.map((asset) => asset.path)).toEqual(['assets/robot.glb']);
    expect([opened.recovery, opened.openElsewhere]).toEqual([null, false]);
    await window.call('project.save', { handle: opened.handle, files: opened.files, revision: opened.revision, overwrite: false });
    await expect(window.call('project.create', { path, template: 'empty' })).rejects.toMatchObject({ diagnostic: { code: 'SCR061' } });
  });

  test('is refused in words where the name of its folder is too long', async () => {
    const window = openWindow(startHost(), 'a');
    const path = join(base, 'long'.repeat(100));
    await expect(window.call('project.create', { path, template: 'empty' })).rejects.toMatchObject({
      diagnostic: { code: 'SCR060', message: 'A name in this path is too long. Nothing was changed.' },
    });
    await expect(window.call('project.open', { path })).rejects.toMatchObject({
      diagnostic: { code: 'SCR004', message: 'A name in this path is too long, so nothing of that name exists.' },
    });
  });

  test('leaves nothing where the disk is full', async () => {
    const full: FileLayer = {
      ...NODE_FILES,
      writeNew: (path, bytes) => {
        if (path.includes('robot.glb')) return Promise.reject(Object.assign(new Error('ENOSPC'), { code: 'ENOSPC' }));
        return NODE_FILES.writeNew(path, bytes);
      },
    };
    const asked = openWindow(startHost(full), 'a').call('project.create', { path: join(base, 'new'), template: 'occlusion' });
    await expect(asked).rejects.toMatchObject({ diagnostic: { code: 'SCR062' } });
    expect(await readdir(join(base, 'new'))).toEqual([]);
  });
});
