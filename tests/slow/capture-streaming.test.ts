import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { importCapture } from '../../app/services/add-capture.ts';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { UNKNOWN_SIZE } from '../../app/services/measure-capture.ts';
import { prepareAssets } from '../../export/bundle/assets/prepare-assets.ts';
import { readCapture } from '../../nodes/kit/capture.ts';
import { openModule, useBrowser } from '../support/browser.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { type LoadingCurve, meanCurve, plotQuality } from '../support/quality-plot.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Streamed } from './capture-streaming.page.ts';

const chromium = useBrowser();

/** Limits the network of a page to 1.6 Mbit/s with 100 ms per request. Files in the cache are loaded again. */
async function slowDown(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send('Network.enable');
  await session.send('Network.setCacheDisabled', { cacheDisabled: true });
  await session.send('Network.emulateNetworkConditions', {
    offline: false,
    latency: 100,
    downloadThroughput: 200_000,
    uploadThroughput: 200_000,
  });
}

/** With `SCRIM_ALL_VIEWS=1`, the test draws this figure of the documentation. */
const PLOT = resolve('docs/images/capture-streaming.svg');
const PLOTTED = {
  title: 'How good the living room looks while it loads',
  description:
    'PSNR of each of 18 views against its photograph, rendered from the 17 other photographs while these load over 1.6 Mbit/s, and the mean of all views.',
};

/** The camera that the visitor stands at: not the one in the middle. */
const VIEW = 2;

describeWithData('the page of a captured living room', 'captures/icl-livingroom', (folder) => {
  test('shows it after a coarse mesh and one photograph, then loads what the visitor sees, and ends as if loaded whole', async () => {
    const base = await mkdtemp(join(tmpdir(), 'scrim-streaming-'));
    await writeProject(base, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
    const { path, asset } = await importCapture({
      folder,
      root: base,
      sources: resolve('.'),
      name: 'room',
      maxSidePx: 320,
      up: null,
      metersPerUnit: 1,
      known: UNKNOWN_SIZE,
      depth: { from: 'none', unit: null, kind: null },
      files: NODE_FILES,
      say: () => {},
      interrupted: new AbortController().signal,
    });
    const { output } = await prepareAssets([{ id: asset, kind: 'capture', path }], {
      root: resolve('.'),
      compress: true,
      cache: null,
      streams: true,
      say: () => {},
      readAsset: (file) => readFile(join(base, file)),
    });
    const [prepared] = output?.assets ?? [];
    if (!prepared) throw new Error('The capture cannot be exported.');
    const page = join(base, 'page');
    await mkdir(join(page, 'assets'), { recursive: true });
    for (const { path: to, bytes } of [prepared, ...prepared.others]) await writeFile(join(page, to), bytes);
    const { coarseMesh, mesh, views } = readCapture(new TextDecoder().decode(prepared.bytes));
    expect(coarseMesh?.triangleCount).toBeLessThan(3100);
    expect(mesh.triangleCount).toBe(60_000);

    const module = await openModule(chromium.browser, 'tests/slow/capture-streaming.page.ts', { mounts: { '/page/': page } });
    if (process.env.SCRIM_ALL_VIEWS) await slowDown(module.page);
    const { steps, totalBytes, equalsWhole, leaks, error } = await module.call<Streamed>('stream', '/page/', prepared.path, VIEW);
    const all = process.env.SCRIM_ALL_VIEWS ? views.keys() : [VIEW];
    const curves: (LoadingCurve & { error: number })[] = [];
    for (const view of all) curves.push(await module.call('rephotographWhileLoading', '/page/', prepared.path, view));
    expect(module.errors).toEqual([]);
    await module.close();
    await rm(base, { recursive: true });
    expect({ equalsWhole, leaks, error }).toEqual({ equalsWhole: true, leaks: false, error: 0 });

    const files = steps.map(({ file }) => basename(file));
    expect(files[0]).toBe(coarseMesh?.file);
    // The first image needs the coarse mesh and one photograph of at most 100 KB: 0.8 s over 1.6 Mbit/s.
    const first = steps.findIndex(({ psnrDb }) => psnrDb !== null);
    expect(first).toBe(2);
    expect(steps[first]?.bytesBefore).toBeLessThan(160_000);
    // The first drawing asks for the photograph of the camera where the visitor stands; one is under way then.
    expect(files[3]).toBe(views[VIEW]?.file);
    expect(files[5]).toBe(mesh.file);
    expect(new Set(files).size).toBe(files.length);
    const quality = steps.map(({ psnrDb }) => psnrDb ?? 0);
    if (process.env.SCRIM_ALL_VIEWS) console.log(steps, totalBytes);
    // A third of the bytes show most of it, and the last photographs hardly change it.
    expect(quality[4]).toBeGreaterThan(20);
    expect(quality.at(-1)).toBeGreaterThan(35);
    expect(quality[first]).toBeLessThan(quality[4] ?? 0);

    // Against photographs that are left out, it also improves most at the beginning.
    expect(curves.map((curve) => curve.error)).toEqual(curves.map(() => 0));
    const { steps: means, finalDb } = meanCurve(curves);
    expect(means.findIndex(({ psnrDb }) => psnrDb >= 0.9 * finalDb)).toBeLessThan(means.length / 2);
    if (process.env.SCRIM_ALL_VIEWS) {
      console.log(meanCurve(curves));
      await writeFile(PLOT, plotQuality(curves, PLOTTED));
    }
  });
});
