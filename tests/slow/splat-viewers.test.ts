import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { SplatPoint } from '../../tools/examples/splats/write-sog.ts';
import type { SplatShot } from '../browser/splats.page.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { plyOf, splatAt, splatCloud } from '../support/splat-files.ts';
import { rasterize } from '../support/splat-reference.ts';

/*
 * The node compared with GaussianSplats3D, a viewer for three.js that has nothing in common with it: each reads the same file with its own
 * code and draws it for the same camera. By its code, the viewer ends splats at √8 standard deviations, where alpha may still be 0.018;
 * here they end at alpha 1/255. It also leaves out splats whose center is 1.2 times outside the view, and blends in bytes.
 */
const chromium = useBrowser();
let ourPage: PageModule;
let viewerPage: PageModule;
beforeAll(async () => {
  ourPage = await openModule(chromium.browser, 'tests/browser/splats.page.ts');
  viewerPage = await openModule(chromium.browser, 'tests/slow/splat-viewers.page.ts');
});
afterAll(async () => {
  for (const page of [ourPage, viewerPage]) {
    await page.close();
    expect(page.errors).toEqual([]);
  }
});

const EYE = [0.3, 0.2, 0.4] as const;
const VIEW = { eye: EYE, target: [0, 0, -2], widthPx: 160, heightPx: 120 } as const;
const VIEWER_ENDS_AT = Math.sqrt(8);

/** Splats whose centers are in the view. */
function visibleCloud(count: number, coefficients: number): SplatPoint[] {
  return splatCloud(count, coefficients).filter(({ position: [x, y, z] }) => {
    const away = EYE[2] - z;
    return away > 1.2 && Math.hypot(x - EYE[0], y - EYE[1]) < 0.4 * away;
  });
}

/** The file. The viewer draws the last splat of a file wrong, so that splat is behind the eye. */
function fileOf(splats: readonly SplatPoint[]): Uint8Array {
  return plyOf([...splats, { ...(splats[0] ?? splatAt(0, 0, 0)), position: [0, 0, 30] }]);
}

const shoot = (bytes: Uint8Array): Promise<SplatShot> => ourPage.call('draw', { bytes, name: 'a.ply', ...VIEW });
const shootByViewer = (bytes: Uint8Array): Promise<Uint8Array> => viewerPage.call('drawByGaussianSplats3d', { bytes, ...VIEW });

/** Decibels. */
function psnr(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += ((a[i] ?? 0) - (b[i] ?? 0)) ** 2;
  return 10 * Math.log10(255 ** 2 / (sum / a.length));
}

/** Where the alpha is, in pixels from the lower left, and the part of pixels that is covered by half at least. */
function covered(pixels: ArrayLike<number>): { readonly x: number; readonly y: number; readonly share: number } {
  let [x, y, sum, many] = [0, 0, 0, 0];
  const count = pixels.length / 4;
  for (let i = 0; i < count; i++) {
    const alpha = pixels[4 * i + 3] ?? 0;
    x += alpha * ((i % VIEW.widthPx) + 0.5);
    y += alpha * (Math.floor(i / VIEW.widthPx) + 0.5);
    sum += alpha;
    if (alpha >= 128) many++;
  }
  return { x: x / sum, y: y / sum, share: many / count };
}

test.each([
  [0, 250],
  [3, 250],
  [8, 250],
  [8, 800],
])('with %i harmonics, %i splats look as in another viewer', async (coefficients, count) => {
  const splats = visibleCloud(count, coefficients);
  const bytes = fileOf(splats);
  const ours = await shoot(bytes);
  const theirs = await shootByViewer(bytes);
  const [here, there] = [covered(ours.pixels), covered(theirs)];
  const { clipFromView, viewFromWorld } = ours;
  const ended = rasterize(splats, { ...VIEW, clipFromView, viewFromWorld, eyeWorld: EYE, endsAt: VIEWER_ENDS_AT });
  expect(here.share).toBeGreaterThan(0.4);
  expect(Math.abs(here.share - there.share)).toBeLessThan(0.005);
  expect(Math.hypot(here.x - there.x, here.y - there.y)).toBeLessThan(0.2);
  expect(psnr(ours.pixels, theirs)).toBeGreaterThan(45);
  // Where its splats end is most of the difference; bytes in between are the rest.
  expect(psnr(theirs, ended)).toBeGreaterThan(50);
});

test('a single splat has the same place, size, turn and color', async () => {
  for (const splat of visibleCloud(16, 8)) {
    const bytes = fileOf(Array.from({ length: 12 }, (_, i) => (i === 0 ? splat : { ...splat, position: [0, 0, 20 + i] as const })));
    const ours = await shoot(bytes);
    const theirs = await shootByViewer(bytes);
    const [here, there] = [covered(ours.pixels), covered(theirs)];
    expect(Math.hypot(here.x - there.x, here.y - there.y)).toBeLessThan(0.1);
    expect(psnr(ours.pixels, theirs)).toBeGreaterThan(55);
  }
});

test('a splat that is thinner than a pixel is widened as much', async () => {
  const thin = splatAt(0.2, 0.1, -1.6, { scale: [0.1, 0.002, 0.002], opacity: 0.8 });
  const bytes = fileOf(Array.from({ length: 12 }, (_, i) => (i === 0 ? thin : { ...thin, position: [0, 0, 20 + i] as const })));
  const sum = (pixels: Uint8Array): number => pixels.reduce((total, value, i) => (i % 4 === 3 ? total + value : total), 0);
  const ours = sum((await shoot(bytes)).pixels);
  expect(ours).toBeGreaterThan(2000);
  expect(Math.abs(ours / sum(await shootByViewer(bytes)) - 1)).toBeLessThan(0.08);
});
