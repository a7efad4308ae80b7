import { cp, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type CaptureJob, importCapture } from '../../app/services/add-capture.ts';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { openModule, useBrowser } from '../support/browser.ts';
import { visitExportedPage } from '../support/exported-page.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
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
const METHODS = ['plain', 'nearest without occlusion', 'nearest', 'lumigraph', 'depth-meshes'] as const;

const DEPTH: CaptureJob['depth'] = { from: 'files', unit: null, kind: null };
const jobFor = (folder: string): CaptureJob => ({
  ...{ folder, root: base, name: 'room', maxSidePx: 1600, up: null, metersPerUnit: 1, depth: { ...DEPTH, from: 'mesh' } },
  ...{ files: NODE_FILES, say: () => {}, interrupted: new AbortController().signal },
});

describeWithData('a captured living room', 'captures/icl-livingroom', (folder) => {
  test('is imported, and looks in views that were left out more like the photograph than by simpler methods', async () => {
    await writeProject(base, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
    const imported = await importCapture(jobFor(folder));
    expect(imported).toMatchObject({ path: 'assets/room.capture/capture.json', up: '-y', triangleCount: 60_000, diagnostics: [] });
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
      for (const method of METHODS) sums.set(method, (sums.get(method) ?? 0) + (shot.psnr[method] ?? Number.NaN));
      rows.push([view, ...METHODS.map((method) => (shot.psnr[method] ?? Number.NaN).toFixed(2))].join(' | '));
    }
    await page.close();
    if (process.env.SCRIM_ALL_VIEWS) console.log(['view', ...METHODS].join(' | '), `\n${rows.join('\n')}`);
    const mean = (method: (typeof METHODS)[number]) => (sums.get(method) ?? 0) / rows.length;
    expect(mean('lumigraph') - mean('plain')).toBeGreaterThan(3);
    expect(mean('lumigraph') - mean('nearest without occlusion')).toBeGreaterThan(2.8);
    expect(mean('lumigraph') - mean('nearest')).toBeGreaterThan(0.3);
    expect(mean('depth-meshes') - mean('plain')).toBeGreaterThan(2.5);
    expect(mean('depth-meshes') - mean('nearest without occlusion')).toBeGreaterThan(2.5);
    expect(mean('depth-meshes') - mean('nearest')).toBeGreaterThan(-0.3);
  });

  test('has depth meshes of a tenth of the triangles of all pixels, which an exported page draws', async () => {
    // Four of the photographs suffice.
    const some = join(base, 'some');
    const photos = (await readdir(join(folder, 'images'))).sort().slice(6, 10);
    for (const name of ['sparse', 'depth', 'mesh.ply', ...photos.map((photo) => `images/${photo}`)]) {
      await cp(join(folder, name), join(some, name), { recursive: true });
    }
    const { path, views, depthTriangles } = await importCapture({ ...jobFor(some), name: 'small', maxSidePx: 320, depth: DEPTH });
    expect(depthTriangles).toBeLessThan(views.length * 2 * 319 * 239 * 0.16);
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
});

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
