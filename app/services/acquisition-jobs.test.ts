import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { readCapture } from '../../nodes/kit/capture.ts';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { projectText } from '../../tests/support/project-kit.ts';

const SIDE = 16;
const SIZE = { widthPx: SIDE, heightPx: SIDE };
const PROJECT = projectText({ nodes: { 'screen-a1b2': 'output/screen' }, wires: [] });
const BEGIN = {
  name: 'A wall',
  camera: { projection: 'perspective' as const, ...SIZE, fovYRad: Math.PI / 2 },
  // Both look along −z, half a meter apart.
  poses: [-0.25, 0.25].map((x) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 1.5, 0, 1]),
};

let base = '';
let project = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-acquisitions-'));
  project = join(base, 'project');
  await mkdir(project);
  await writeFile(join(project, 'project.scrim.json'), PROJECT);
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

async function open() {
  const window = openWindow(startHost(), 'a');
  const { handle } = await window.call('project.open', { path: project });
  /** A gray wall at this distance. */
  const add = (index: number, meters: number) =>
    window.call('capture.add', {
      handle,
      index,
      colorSize: SIZE,
      depthSize: SIZE,
      rgba: new Uint8Array(4 * SIDE * SIDE).fill(meters > 0 ? 255 : 0),
      meters: new Uint8Array(new Float32Array(SIDE * SIDE).fill(meters).buffer),
    });
  return { ...window, handle, add };
}

const staged = async () => (await readdir(tmpdir())).filter((name) => name.startsWith('scrim-photographs-'));

describe('photographs that an editor takes', () => {
  test('become a capture in meters, which the host leaves to the editor to list', async () => {
    const before = await staged();
    const { call, handle, add } = await open();
    await call('capture.begin', { handle, ...BEGIN });
    await add(0, 2);
    await add(1, 2);
    const { path, diagnostics } = await call('capture.finish', { handle });
    expect(path).toBe('assets/A-wall.capture/capture.json');
    expect(diagnostics.map(({ code, severity }) => [code, severity])).toEqual([['SCR069', 'warning']]);
    const { views } = readCapture(await readFile(join(project, path ?? ''), 'utf8'));
    expect(views.map(({ worldFromCamera }) => worldFromCamera)).toEqual(
      BEGIN.poses.map((pose) => pose.map((value) => expect.closeTo(value, 6))),
    );
    const mesh = await readFile(join(project, 'assets/A-wall.capture/mesh.bin'));
    // All points of the wall lie 2 m in front of the cameras.
    expect(mesh.readFloatLE(8)).toBeCloseTo(-2, 3);
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe(PROJECT);
    expect(await staged()).toEqual(before);
  });

  test('leave nothing if they are canceled, wrong, or show nothing', async () => {
    const before = await staged();
    const { call, handle, add } = await open();
    await call('capture.begin', { handle, ...BEGIN });
    await add(0, 2);
    await call('capture.cancel', { handle });
    await expect(add(1, 2)).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });

    await call('capture.begin', { handle, ...BEGIN });
    await expect(add(2, 2)).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await add(0, 0);
    await add(1, 0);
    await expect(call('capture.finish', { handle })).rejects.toMatchObject({
      diagnostic: { code: 'SCR069', message: 'No photograph shows anything.' },
    });
    const scaled = BEGIN.poses.map((pose) => [...pose.slice(0, 15), 2]);
    await expect(call('capture.begin', { handle, ...BEGIN, poses: scaled })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    expect(await staged()).toEqual(before);
    expect(await readdir(project)).not.toContain('assets');
  });
});
