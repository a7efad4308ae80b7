import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { visitExportedPage } from '../support/exported-page.ts';
import { pixelAt } from '../support/image.ts';
import { serveProject, serveProjectText } from '../support/project-page.ts';
import { openXrPage, readCapture } from '../xr/xr-page.ts';

const chromium = useBrowser();
const EXAMPLE = resolve('nodes/source/splats/example');

test('an exported page has one file of splats, shows them, and contains no three.js', async () => {
  const served = await serveProject(EXAMPLE);
  expect(await readdir(join(served.folder, 'assets'))).toEqual([expect.stringMatching(/^vase-\w+\.sog$/)]);
  const report = JSON.parse(await readFile(join(served.folder, 'report.json'), 'utf8')) as { modules: { page: Record<string, number> } };
  const ofSplats = Object.entries(report.modules.page).filter(([file]) => /splat|sog|zip-files|radix|depth-sort|morton/.test(file));
  expect(ofSplats.length).toBeGreaterThan(10);
  // Compressed it is about a third.
  expect(ofSplats.reduce((sum, [, bytes]) => sum + bytes, 0)).toBeLessThan(30_000);
  const script = (await readdir(served.folder)).find((name) => name.startsWith('page') && name.endsWith('.js')) ?? '';
  expect(await readFile(join(served.folder, script), 'utf8')).not.toContain('THREE.');
  await visitExportedPage(chromium.browser, served.folder);
  await served.close();
});

test('in a headset each eye sees the splats from its own place', async () => {
  const sog = await readFile(join(EXAMPLE, 'assets/vase.sog'));
  const text = {
    title: 'A vase before the eyes',
    nodes: {
      'vase-a1b2': ['source/splats', { file: 'vase', up: 'y', positionM: [0, 1.3, -1] }] as const,
      'screen-a1b2': 'output/screen',
    },
    wires: ['vase-a1b2.layer -> screen-a1b2.layer'],
    assets: { vase: { path: 'assets/vase.sog', kind: 'splats' } as const },
  };
  const served = await serveProjectText(text, { 'assets/vase.sog': sog });
  const [width, height] = [640, 480];
  const xr = await openXrPage(
    chromium.browser,
    served.url,
    { room: await readCapture('living_room'), device: 'headset' },
    { width, height },
  );
  await xr.enter();
  await xr.setPose({ position: [0, 1.4, 0], quaternion: [0, 0, 0, 1] });
  /** The mean place of the splats in each half of the image, pixels from the left of the half. */
  const middles = async (): Promise<number[]> => {
    const layer = await xr.readLayer();
    return [0, width / 2].map((left) => {
      let sum = 0;
      let alphas = 0;
      for (let y = 0; y < height; y += 2) {
        for (let x = left; x < left + width / 2; x++) {
          const alpha = pixelAt(layer, x, y)[3];
          sum += alpha * (x + 0.5 - left);
          alphas += alpha;
        }
      }
      return sum / alphas;
    });
  };
  const views = await xr.page.evaluate(async () => {
    const session = (scrimEmulator?.current?.device as unknown as { activeSession?: XRSession })?.activeSession;
    const space = await session?.requestReferenceSpace('local-floor');
    const told = new Promise<{ x: number; projection: number[] }[]>((done) => {
      session?.requestAnimationFrame((_time, frame) => {
        const seen = (space && frame.getViewerPose(space)?.views) ?? [];
        done(seen.map(({ transform, projectionMatrix }) => ({ x: transform.position.x, projection: [...projectionMatrix] })));
      });
    });
    await scrimEmulator?.current?.stepFrame();
    return told;
  });
  expect(views).toHaveLength(2);
  let found = await middles();
  // The file arrives, and a worker answers with the order, some frames later.
  for (let tries = 0; tries < 50 && !found.every(Number.isFinite); tries++) {
    await xr.step(2);
    found = await middles();
  }
  views.forEach(({ x, projection }, i) => {
    const ndc = -(projection[0] ?? 0) * x - (projection[8] ?? 0);
    expect(Math.abs((found[i] ?? 0) - (ndc * 0.5 + 0.5) * (width / 2))).toBeLessThan(1.5);
  });
  expect(Math.abs((found[0] ?? 0) - (found[1] ?? 0))).toBeGreaterThan(5);
  expect(xr.errors).toEqual([]);
  await xr.close();
  await served.close();
});
