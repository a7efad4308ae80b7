import { cp, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type CaptureJob, type ImportedCapture, importCapture } from '../../app/services/add-capture.ts';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { UNKNOWN_SIZE } from '../../app/services/measure-capture.ts';
import { type Acquired, acquire } from '../support/acquisition.ts';
import { openModule, useBrowser } from '../support/browser.ts';
import { visitExportedPage } from '../support/exported-page.ts';
import { type ProjectText, projectText, writeProject } from '../support/project-kit.ts';
import { serveProject } from '../support/project-page.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Rephotograph } from './capture.page.ts';

const chromium = useBrowser();
let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-capture-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** Views that are measured in each run. */
const VIEWS = [4, 8];
const METHODS = ['plain', 'nearest without occlusion', 'nearest', 'lumigraph', 'lumigraph per vertex', 'depth-meshes'] as const;

const DEPTH: CaptureJob['depth'] = { from: 'files', unit: null, kind: null };
const jobFor = (folder: string): CaptureJob => ({
  ...{
    folder,
    root: base,
    sources: resolve('.'),
    name: 'room',
    maxSidePx: 1600,
    up: null,
    metersPerUnit: 1,
    known: UNKNOWN_SIZE,
    depth: { ...DEPTH, from: 'mesh' },
  },
  files: NODE_FILES,
  say: () => {},
  interrupted: new AbortController().signal,
});

let small: ImportedCapture | null = null;
/** Four of the photographs suffice. */
async function importSmall(folder: string): Promise<ImportedCapture> {
  if (small) return small;
  await writeProject(base, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  const some = join(base, 'some');
  const photos = (await readdir(join(folder, 'images'))).sort().slice(6, 10);
  for (const name of ['sparse', 'depth', 'mesh.ply', ...photos.map((photo) => `images/${photo}`)]) {
    await cp(join(folder, name), join(some, name), { recursive: true });
  }
  small = await importCapture({ ...jobFor(some), name: 'small', maxSidePx: 320, depth: DEPTH });
  return small;
}

/** Takes a picture of nodes from the door of the room; they may read the captures `room` and `ball`, and the model `robot`. */
async function takeFromDoor(folder: string, nodes: ProjectText['nodes'], wires: readonly string[], name: string): Promise<Acquired> {
  const { path } = await importSmall(folder);
  await cp(resolve('examples/first-light/assets/robot.glb'), join(base, 'assets/robot.glb'));
  await cp(resolve(BALL), join(base, 'assets/ball.capture'), { recursive: true });
  const assets = {
    room: { path, kind: 'capture' },
    ball: { path: 'assets/ball.capture/capture.json', kind: 'capture' },
    robot: { path: 'assets/robot.glb', kind: 'model' },
  } as const;
  const text = projectText({ nodes: { ...nodes, 'screen-a1': 'output/screen' }, wires, assets });
  await writeProject(base, { 'project.scrim.json': text });
  const out = join(base, 'taken');
  const [picture] = await acquire(base, out, ...FROM_THE_DOOR);
  if (process.env.SCRIM_PICTURES)
    await cp(join(out, 'images'), join(process.env.SCRIM_PICTURES, `${name}-${wires.length}`), { recursive: true });
  if (!picture) throw new Error('Nothing was photographed.');
  return picture;
}

let others: Promise<{ readonly robot: Acquired; readonly near: Acquired }> | null = null;
/** The robot and the ball alone, which look the same whatever shows the room. */
function takeOthers(folder: string) {
  const take = async () => ({
    robot: await takeFromDoor(folder, ROBOT, [...ROBOT_WIRES, 'scene-a1.layer -> screen-a1.layer'], 'alone'),
    near: await takeFromDoor(folder, BALL_NODE, ['ball-a1.layer -> screen-a1.layer'], 'alone'),
  });
  others ??= take();
  return others;
}

describeWithData('a captured living room', 'captures/icl-livingroom', (folder) => {
  test('is imported, and looks in views that were left out more like the photograph than by simpler methods', async () => {
    await writeProject(base, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
    const imported = await importCapture(jobFor(folder));
    expect(imported).toMatchObject({ path: 'assets/room.capture/capture.json', up: '-y', triangleCount: 60_000, diagnostics: [] });
    expect(imported.depthTriangles).toBeLessThan(imported.views.length * 2 * 639 * 479 * 0.03);
    expect(imported.views.every(({ errorPx }) => errorPx !== null && errorPx < 0.01)).toBe(true);
    expect(JSON.parse(await readFile(join(base, 'project.scrim.json'), 'utf8'))).toMatchObject({
      assets: { [imported.asset]: { kind: 'capture', path: imported.path } },
    });
    const page = await openModule(chromium.browser, 'tests/slow/capture.page.ts', {
      mounts: { '/capture/': join(base, 'assets/room.capture') },
    });
    const sums = new Map<string, number>();
    const views = process.env.SCRIM_ALL_VIEWS ? imported.views.keys() : VIEWS;
    const rows: string[] = [];
    for (const view of views) {
      const shot = await page.call<Rephotograph>('rephotograph', '/capture/', view, METHODS, false);
      expect(shot.error).toBe(0);
      expect(shot.covered).toBeGreaterThan(0.9);
      // What comes after, such as an occlusion, gets the depth in meters; edges differ by a pixel.
      expect(shot.depthDiffers['depth-meshes']).toBeLessThan(0.02);
      // In no view is it much worse than the nearest photographs.
      expect((shot.psnr.lumigraph ?? Number.NaN) - (shot.psnr.nearest ?? Number.NaN)).toBeGreaterThan(-1);
      for (const method of METHODS) sums.set(method, (sums.get(method) ?? 0) + (shot.psnr[method] ?? Number.NaN));
      rows.push([view, ...METHODS.map((method) => (shot.psnr[method] ?? Number.NaN).toFixed(2))].join(' | '));
    }
    // From the side, with a wide angle, more is in view than the nearest photographs show.
    const worldFromCamera = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.55, 0.35, -0.05, 1];
    const wide = { file: '', widthPx: 640, heightPx: 480, fxPx: 343, fyPx: 343, cxPx: 320, cyPx: 240, worldFromCamera };
    // With the colors of the mesh where no depth mesh is, it is 29.2 dB.
    expect(await page.call<number>('compareMethods', '/capture/', wide)).toBeGreaterThan(31);
    await page.close();
    if (process.env.SCRIM_ALL_VIEWS) console.log(['view', ...METHODS].join(' | '), `\n${rows.join('\n')}`);
    const mean = (method: (typeof METHODS)[number]) => (sums.get(method) ?? 0) / rows.length;
    expect(mean('lumigraph') - mean('plain')).toBeGreaterThan(3);
    expect(mean('lumigraph') - mean('nearest without occlusion')).toBeGreaterThan(2.8);
    expect(mean('lumigraph') - mean('nearest')).toBeGreaterThan(0.3);
    // Its mesh is fine enough for weights per vertex.
    expect(mean('lumigraph per vertex') - mean('lumigraph')).toBeGreaterThan(-0.3);
    expect(mean('depth-meshes') - mean('plain')).toBeGreaterThan(2.5);
    expect(mean('depth-meshes') - mean('nearest without occlusion')).toBeGreaterThan(2.5);
    expect(mean('depth-meshes') - mean('nearest')).toBeGreaterThan(-0.3);
  });

  test('has depth meshes of less than a tenth of the triangles of all pixels, which an exported page draws', async () => {
    const { path, views, depthTriangles } = await importSmall(folder);
    expect(depthTriangles).toBeLessThan(views.length * 2 * 319 * 239 * 0.05);
    const node = ['source/capture', { file: 'small', method: 'depth-meshes' }] as const;
    const nodes = { 'place-a1': node, 'screen-a1': 'output/screen' };
    const assets = { small: { path, kind: 'capture' } } as const;
    await writeProject(base, { 'project.scrim.json': projectText({ nodes, wires: ['place-a1.layer -> screen-a1.layer'], assets }) });
    const served = await serveProject(base);
    const names = await readdir(join(served.folder, 'assets'));
    // Those of the views, the mesh and its coarse form.
    expect(names.filter((name) => name.endsWith('.bin'))).toHaveLength(views.length + 2);
    expect(names.filter((name) => name.endsWith('.png'))).toEqual([]);
    await visitExportedPage(chromium.browser, served.folder);
    await served.close();
  });

  test.each(['lumigraph', 'depth-meshes'] as const)(
    'shown by %s, hides a robot behind its chair, receives its shadow, and takes fog together with another capture',
    async (method) => {
      const { robot, near } = await takeOthers(folder);
      const take = (nodes: ProjectText['nodes'], ...wires: readonly string[]) => takeFromDoor(folder, nodes, wires, method);
      const place = { 'place-a1': ['source/capture', { file: 'room', method }] } as const;
      const alone = await take(place, 'place-a1.layer -> screen-a1.layer');
      const both = await take(
        {
          ...place,
          ...ROBOT,
          'mesh-a1': ['source/capture-mesh', { file: 'room' }],
          'shadow-a1': 'layer/shadow',
          'under-a1': 'operator/over',
          'over-a1': 'operator/over',
        },
        ...[...ROBOT_WIRES, 'mesh-a1.objects -> scene-a1.objects', 'mesh-a1.objects -> shadow-a1.receivers'],
        ...['stand-a1.objects -> shadow-a1.casters', 'sun-a1.lights -> shadow-a1.lights', 'shadow-a1.layer -> under-a1.top'],
        ...['place-a1.layer -> under-a1.bottom', 'under-a1.layer -> over-a1.bottom', 'scene-a1.layer -> over-a1.top'],
        'over-a1.layer -> screen-a1.layer',
      );
      const count = { hidden: 0, inFront: 0, shaded: 0, other: 0 };
      const wrong = { ...count };
      alone.meters.forEach((placeM, i) => {
        const [was, now, seen] = [alone, both, robot].map((picture) => colorAt(picture, i)) as [Color, Color, Color];
        const isRobot = robot.pixels[4 * i + 3] === 255;
        const robotM = robot.meters[i] ?? 0;
        const share = brightness(now) / brightness(was);
        // Edges of the chair are those of its depth, which differ from those of its mesh.
        if (!isEven(alone, i) || (isRobot && !isEven(robot, i))) return;
        if (isRobot && robotM > placeM + 0.1) {
          count.hidden++;
          // It may lie in the shadow.
          if (share > 1.02 || share < 0.4 || Math.abs((both.meters[i] ?? 0) - placeM) > 0.03) wrong.hidden++;
        } else if (isRobot && robotM < placeM - 0.1) {
          count.inFront++;
          if (difference(now, seen) > 3 || Math.abs((both.meters[i] ?? 0) - robotM) > 0.01) wrong.inFront++;
        } else if (robot.pixels[4 * i + 3] === 0) {
          if (share < 0.8) count.shaded++;
          else count.other++;
          // The shadow lies on the floor and the sideboard, beside the robot, which the sun shines on from the window on the left.
          if (share < 0.8 && i < 0.5 * alone.meters.length) wrong.shaded++;
          if (share > 1.02) wrong.other++;
        }
      });
      if (process.env.SCRIM_PICTURES) console.log(method, count, wrong);
      expect(count.hidden).toBeGreaterThan(250);
      expect(count.inFront).toBeGreaterThan(250);
      expect(count.shaded).toBeGreaterThan(500);
      expect(wrong.hidden / count.hidden).toBeLessThan(0.05);
      expect(wrong.inFront / count.inFront).toBeLessThan(0.02);
      expect([wrong.shaded, wrong.other]).toEqual([0, 0]);

      const foggy = await take(
        { ...place, ...BALL_NODE, 'over-a1': 'operator/over', 'fog-a1': ['filter/fog', { near: 0.5, far: 3, color: FOG }] },
        ...['place-a1.layer -> over-a1.bottom', 'ball-a1.layer -> over-a1.top', 'over-a1.layer -> fog-a1.inputImage'],
        'fog-a1.layer -> screen-a1.layer',
      );
      const differences = { ball: [] as number[], room: [] as number[] };
      foggy.meters.forEach((_, i) => {
        const isBall = near.pixels[4 * i + 3] === 255;
        const from = isBall ? near : alone;
        if (!isEven(from, i) || from.pixels[4 * i + 3] !== 255 || (near.pixels[4 * i + 3] ?? 0) % 255 !== 0) return;
        const fog = 1 - Math.exp((-2.9957 * Math.max(0, (from.meters[i] ?? 0) - 0.5)) / 2.5);
        const expected = colorAt(from, i).map((value, c) => value + fog * (255 * (FOG[c] ?? 0) - value)) as unknown as Color;
        differences[isBall ? 'ball' : 'room'].push(difference(expected, colorAt(foggy, i)));
      });
      for (const list of Object.values(differences)) {
        expect(list.length).toBeGreaterThan(400);
        expect(list.sort((a, b) => a - b)[Math.floor(0.98 * list.length)]).toBeLessThan(3);
      }
    },
  );
});

const BALL = 'nodes/source/capture-mesh/example/assets/glossy-ball.capture';
const BALL_NODE: ProjectText['nodes'] = {
  'ball-a1': ['source/capture', { file: 'ball', method: 'lumigraph', positionM: [0.55, -0.42, -1], scale: 0.4 }],
};
const FOG = [0.75, 0.79, 0.84, 1];
const FROM_THE_DOOR = [
  ...['--shape', 'grid', '--count', '1x1x1', '--extent', '0', '--center', '0.55,0.35,-0.05'],
  ...['--fov', '70', '--size', '320x240'],
];
const ROBOT: ProjectText['nodes'] = {
  'model-a1': ['source/model', { model: 'robot' }],
  'stand-a1': ['objects/transform', { positionM: [0.42, -0.42, -1.6], scale: 1.3 }],
  'sun-a1': ['light/directional', { azimuthRad: -1.9, elevationRad: 0.75 }],
  'scene-a1': 'layer/scene',
};
const ROBOT_WIRES = ['model-a1.objects -> stand-a1.objects', 'stand-a1.objects -> scene-a1.objects', 'sun-a1.lights -> scene-a1.lights'];

type Color = readonly [number, number, number];

function colorAt({ pixels }: Acquired, i: number): Color {
  return [pixels[4 * i] ?? 0, pixels[4 * i + 1] ?? 0, pixels[4 * i + 2] ?? 0];
}

function brightness([red, green, blue]: Color): number {
  return red + green + blue + 1;
}

function difference(a: Color, b: Color): number {
  return Math.max(...a.map((value, c) => Math.abs(value - (b[c] ?? 0))));
}

/** Whether a pixel and the eight around it are opaque and at nearly the same distance. */
function isEven({ widthPx, meters, pixels }: Acquired, i: number): boolean {
  const m = meters[i] ?? 0;
  return [-1, 0, 1].every((row) =>
    [-1, 0, 1].every((column) => {
      const at = i + row * widthPx + column;
      return pixels[4 * at + 3] === 255 && Math.abs((meters[at] ?? 0) - m) < 0.05;
    }),
  );
}

test('an exported page fetches the files of a capture singly, shows it, and contains no three.js', async () => {
  const served = await serveProject(resolve('nodes/source/capture/example'));
  const names = await readdir(join(served.folder, 'assets'));
  expect(names.filter((name) => /^glossy-ball-\d{3}-\w+\.jpg$/.test(name))).toHaveLength(20);
  expect(names.filter((name) => /^glossy-ball-mesh-\w+\.bin$/.test(name))).toHaveLength(1);
  const script = (await readdir(served.folder)).find((name) => name.endsWith('.js') && name.startsWith('page')) ?? '';
  expect(await readFile(join(served.folder, script), 'utf8')).not.toMatch(/THREE\.|uniform float nearer/);
  await visitExportedPage(chromium.browser, served.folder);
  await served.close();
});

test('an exported page shows a capture with the phantom of its mesh, which share one asset', async () => {
  const served = await serveProject(resolve('nodes/source/capture-mesh/example'));
  const names = await readdir(join(served.folder, 'assets'));
  expect(names.filter((name) => /^glossy-ball-mesh-\w+\.bin$/.test(name))).toHaveLength(1);
  await visitExportedPage(chromium.browser, served.folder);
  await served.close();
});
