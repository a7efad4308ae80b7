import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { projectText } from '../../tests/support/project-kit.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';

const SIZE = { widthPx: 2, heightPx: 1 };
/** A red pixel, and half of a green one. */
const PIXELS = Uint8Array.of(255, 0, 0, 255, 0, 128, 0, 128);

let base = '';
let project = '';
let out = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-frames-'));
  project = join(base, 'project');
  out = join(base, 'frames');
  await mkdir(project);
  await writeFile(join(project, 'project.scrim.json'), projectText({ nodes: { 'screen-a1b2': 'output/screen' }, wires: [] }));
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

async function open(files: FileLayer = NODE_FILES) {
  const window = openWindow(startHost(files), 'a');
  const { handle } = await window.call('project.open', { path: project });
  return { ...window, handle, add: (number: number, rgba = PIXELS) => window.call('frames.add', { handle, number, rgba }) };
}

const finish = { title: 'Mine', frameRateHz: 10 };
/** What stands beside the project. */
const left = async () => (await readdir(base)).filter((name) => name !== 'project');

describe('frames that an editor renders', () => {
  test('appear all at once, by their numbers, with a list', async () => {
    const { call, handle, add } = await open();
    await call('frames.begin', { handle, out, ...SIZE });
    await add(7);
    await add(8);
    expect((await left()).filter((name) => name === 'frames')).toEqual([]);
    expect(await call('frames.finish', { handle, ...finish })).toEqual({ out, pictures: 2 });
    expect(await left()).toEqual(['frames']);
    expect((await readdir(out)).sort()).toEqual(['000007.png', '000008.png', 'sequence.json']);
    const { width, height, data } = decode(await readFile(join(out, '000007.png')));
    // Straight alpha, as PNG has it.
    expect([width, height, ...data]).toEqual([2, 1, 255, 0, 0, 255, 0, 255, 0, 128]);
    expect(JSON.parse(await readFile(join(out, 'sequence.json'), 'utf8'))).toMatchObject({ title: 'Mine', frameRateHz: 10, ...SIZE });
  });

  test('take the place of those rendered before, whole, and of nothing else', async () => {
    const { call, handle, add } = await open();
    for (const number of [1, 2]) {
      await call('frames.begin', { handle, out, ...SIZE });
      await add(number);
      await call('frames.finish', { handle, ...finish });
    }
    expect((await readdir(out)).sort()).toEqual(['000002.png', 'sequence.json']);
    await writeFile(join(out, 'mine.png'), 'x');
    await expect(call('frames.begin', { handle, out, ...SIZE })).rejects.toMatchObject({
      diagnostic: { code: 'SCR061', fix: expect.stringContaining('rendered earlier') },
    });
    await expect(add(3)).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    expect((await readdir(out)).sort()).toEqual(['000002.png', 'mine.png', 'sequence.json']);
  });

  test('that are cancelled, or whose window is gone, leave nothing', async () => {
    const { call, handle, add, leave } = await open();
    await call('frames.begin', { handle, out, ...SIZE });
    await add(0);
    await call('frames.cancel', { handle });
    expect(await left()).toEqual([]);
    await call('frames.begin', { handle, out: join(base, 'deep', 'in'), ...SIZE });
    await add(0);
    leave();
    // What is tidied away then is awaited by the next who begins.
    await call('frames.cancel', { handle });
    await call('frames.begin', { handle, out, ...SIZE });
    await call('project.close', { handle });
    expect((await left()).filter((name) => name.startsWith('frames'))).toEqual([]);
  });

  test('that do not fit on the disk, or may not be written, say so and leave nothing', async () => {
    let written = 0;
    const full: FileLayer = {
      ...NODE_FILES,
      writeNew: (path, bytes) =>
        ++written > 2 ? Promise.reject(Object.assign(new Error('full'), { code: 'ENOSPC' })) : NODE_FILES.writeNew(path, bytes),
    };
    const { call, handle, add } = await open(full);
    written = 0;
    await call('frames.begin', { handle, out, ...SIZE });
    await add(0);
    await add(1);
    await expect(add(2)).rejects.toMatchObject({ diagnostic: { code: 'SCR062' } });
    expect(await left()).toEqual([]);
    await expect(call('frames.finish', { handle, ...finish })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await writeFile(join(base, 'file'), 'x');
    await expect(call('frames.begin', { handle, out: join(base, 'file', 'in'), ...SIZE })).rejects.toMatchObject({
      diagnostic: { code: 'SCR060' },
    });
  });

  test('have the size that was said', async () => {
    const { call, handle, add } = await open();
    await call('frames.begin', { handle, out, ...SIZE });
    await expect(add(0, PIXELS.subarray(4))).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await expect(call('frames.begin', { handle, out, widthPx: 0, heightPx: 1 })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
  });
});
