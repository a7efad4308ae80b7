import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { playPlacing } from '../../tools/newcomer/play-placing.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { countDifferent } from '../support/pixels.ts';
import { serveStatic } from '../support/serve.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const MODEL = join(ROOT, 'examples/first-light/assets/robot.glb');
const MOST_INTERACTIONS = 20;
/** A measured length with its interval, as on the label. */
const LENGTH = /^\d+(?:\.\d+)? (?:m|cm|ft|in) ± /;
/** From (0, 1.5, 1), 0.7 rad below the horizon. */
const HEAD = { position: [0, 1.5, 1], quaternion: [-Math.sin(0.35), 0, 0, Math.cos(0.35)] } as const;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-placing-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

const browser = useBrowser();

/** Turns two fingers around the middle between them, by a quarter turn. */
async function twist(xr: XrPage, [x, y]: readonly [number, number], radius: number): Promise<void> {
  const put = (act: 'press' | 'move', turn: number) =>
    xr.page.evaluate(
      ([how, ...points]) => {
        for (const [finger, [atX, atY]] of points.entries()) scrimEmulator?.current?.[how](atX, atY, finger);
      },
      [act, ...[0, Math.PI].map((side) => [x + radius * Math.cos(turn + side), y + radius * Math.sin(turn + side)] as const)] as const,
    );
  await put('press', 0);
  await xr.step(2);
  for (let i = 1; i <= 6; i++) {
    await put('move', (i * Math.PI) / 12);
    await xr.step();
  }
  await xr.page.evaluate(() => {
    for (const finger of [0, 1]) scrimEmulator?.current?.release(finger);
  });
  await xr.step(3);
}

test('a newcomer makes a page in which a model is placed, dragged, turned, measured and labeled, in at most 20 interactions', async () => {
  const server = await startServer({ installation: installationAt(ROOT, '0.0.0'), startPath: null, log: () => {} });
  const page = await browser.browser.newPage({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' });
  const errors = collectErrors(page);
  const exportTo = join(base, 'page');
  try {
    await page.goto(server.invite());
    const done = await playPlacing({ page, model: MODEL, project: join(base, 'first'), exportTo });
    expect(done.length).toBeLessThanOrEqual(MOST_INTERACTIONS);
  } finally {
    await page.close();
    await server.close();
  }
  expect(errors).toEqual([]);

  const host = await serveStatic({ '/': exportTo });
  const xr = await openXrPage(browser.browser, `${host.origin}/`, { device: 'phone', room: 'studio' });
  await xr.setPose(HEAD);
  await xr.enter();
  await xr.step(3);
  const empty = await xr.readComposite();
  await xr.touch([0.5, 0.6]);
  const placed = await xr.readComposite();
  expect(countDifferent(placed, empty, 24).pixels).toBeGreaterThan(300);
  await xr.touch([0.5, 0.6], [0.4, 0.65], [0.3, 0.7]);
  const dragged = await xr.readComposite();
  expect(countDifferent(dragged, placed, 24).pixels).toBeGreaterThan(300);
  await twist(xr, [0.3, 0.65], 0.06);
  const turned = await xr.readComposite();
  expect(countDifferent(turned, dragged, 24).pixels).toBeGreaterThan(150);
  await expect(xr.page.getByText(LENGTH).count()).resolves.toBe(0);
  await xr.touch([0.8, 0.7]);
  const measured = await xr.readComposite();
  // A line of a few pixels' width from the first tap to this one.
  expect(countDifferent(measured, turned, 24).pixels).toBeGreaterThan(60);
  await xr.page.getByText(LENGTH).waitFor();
  expect(xr.errors).toEqual([]);
  await xr.close();
  await host.close();
});
