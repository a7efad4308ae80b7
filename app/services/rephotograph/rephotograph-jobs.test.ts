import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { openWindow, startHost, stopHosts } from '../../../tests/support/host-kit.ts';
import { projectText } from '../../../tests/support/project-kit.ts';

const BALL = resolve('nodes/source/capture-mesh/example/assets/glossy-ball.capture');
const PATH = 'assets/ball.capture/capture.json';
const SIZE = { widthPx: 2, heightPx: 1 };

let base = '';
let project = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-rephotograph-jobs-'));
  project = join(base, 'project');
  await mkdir(join(project, 'assets'), { recursive: true });
  await cp(BALL, join(project, 'assets/ball.capture'), { recursive: true });
  await writeFile(join(project, 'project.scrim.json'), projectText({ nodes: { 'screen-a1b2': 'output/screen' }, wires: [] }));
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

async function open() {
  const window = openWindow(startHost(), 'a');
  const { handle } = await window.call('project.open', { path: project });
  const add = (index: number, psnrDb: number | null, more: object = {}) =>
    window.call('rephotograph.add', {
      ...{ handle, index, method: 'lumigraph', size: SIZE, psnrDb, ssim: null, chromaError: 2, covered: 1 },
      picture: Uint8Array.of(255, 0, 0, 255, 0, 0, 0, 0),
      error: Uint8Array.of(13, 8, 135, 255, 0, 0, 0, 255),
      ...more,
    });
  const begin = (more: object = {}) => window.call('rephotograph.begin', { handle, path: PATH, method: 'lumigraph', blended: 2, ...more });
  return { ...window, handle, add, begin };
}

describe('a capture that an editor rephotographs', () => {
  test('gets a report with its photographs, which the host shows', async () => {
    const { call, handle, add, begin } = await open();
    const { methods, views } = await begin();
    expect(methods).toEqual(['lumigraph']);
    for (let i = 0; i < views; i++) await add(i, i === 0 ? null : 20 + i);
    const { means } = await call('rephotograph.finish', { handle });
    // An infinite figure and windows that nothing covers do not count.
    expect(means).toEqual([{ method: 'lumigraph', psnrDb: 20 + views / 2, ssim: null, chromaError: 2, covered: 1 }]);
    const out = join(project, 'reports/ball');
    expect(decode(await readFile(join(out, 'views/000-lumigraph.png'))).data).toEqual(Uint8Array.of(255, 0, 0, 255, 0, 0, 0, 0));
    expect(await readFile(join(out, 'views/000.jpg'))).toEqual(await readFile(join(BALL, 'views/000.jpg')));
    const { url } = await call('rephotograph.show', { handle, path: PATH });
    expect(await (await fetch(url)).text()).toContain('alt="Lumigraph: 21.00 dB"');
    // Again, in place of the first.
    await begin({ method: null });
    await call('rephotograph.cancel', { handle });
    expect(await readdir(join(project, 'reports'))).toEqual(['ball']);
  });

  test('leaves nothing if it is canceled, wrong, or not a capture', async () => {
    const { call, handle, add, begin } = await open();
    await expect(call('rephotograph.show', { handle, path: PATH })).rejects.toMatchObject({ diagnostic: { code: 'SCR004' } });
    await begin();
    await expect(add(1, 20)).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await expect(add(0, 20, { method: 'plain' })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await expect(add(0, 20, { size: { widthPx: 2, heightPx: 2 } })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await add(0, 20);
    await call('rephotograph.cancel', { handle });
    await expect(add(1, 20)).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await expect(begin({ path: '../capture.json' })).rejects.toMatchObject({ diagnostic: { code: 'SCR031' } });
    await expect(begin({ path: 'assets/none.capture/capture.json' })).rejects.toMatchObject({ diagnostic: { code: 'SCR032' } });
    expect(await readdir(project)).not.toContain('reports');
  });

  test('does not replace files of the user', async () => {
    const { begin } = await open();
    await mkdir(join(project, 'reports/ball'), { recursive: true });
    await writeFile(join(project, 'reports/ball/notes.txt'), 'mine');
    await expect(begin()).rejects.toMatchObject({ diagnostic: { code: 'SCR061' } });
    expect(await readdir(join(project, 'reports/ball'))).toEqual(['notes.txt']);
  });
});
