import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
const models = resolve('../shared/data/models');
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/scenes-drawing.page.ts', { mounts: { '/models/': models } });
});
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

interface Difference {
  pixels: number;
  largest: number;
}
const SAME = { pixels: 0, largest: 0 };

test('a layer is premultiplied, whatever is blended in it', async () => {
  expect(await page.call('blending')).toEqual({
    opaque: [0, 255, 0, 255],
    veil: [102, 102, 102, 102],
    // 0.4 of black over 0.4 of white: color 0.6 × 0.4, alpha 0.4 + 0.6 × 0.4.
    darkVeilOverVeil: [61, 61, 61, 163],
    veilOverOpaque: [102, 255, 102, 255],
    // Added light covers nothing.
    glow: [128, 0, 0, 0],
    glowOverOpaque: [128, 255, 0, 255],
    // Clear glass shows what is behind it, in the layer and behind the layer.
    glass: [0, 0, 0, 0],
    glassOverOpaque: [0, 255, 0, 255],
    error: 0,
  });
});

test('a phantom hides what is behind it and shows nothing of itself, in any order', async () => {
  expect(await page.call('phantoms')).toEqual({
    hidden: [0, 0, 0, 0],
    box: [0, 0, 255, 255],
    open: [255, 0, 0, 255],
    orderMatters: 0,
    error: 0,
  });
});

describe('one animated model in two places', () => {
  test.each(['Fox', 'RobotExpressive'])('%s moves as three.js moves it, in both alike, in any order', async (name) => {
    if (!existsSync(`${models}/${name}.glb`)) {
      console.warn(`${models}/${name}.glb is missing: nothing was tested.`);
      return;
    }
    const result = await page.call<Record<string, Difference & number>>('placements', `/models/${name}.glb`);
    expect(result).toMatchObject({ plain: { pixels: 0 }, undisturbed: SAME, order: SAME, error: 0 });
    expect(result.drawn).toBeGreaterThan(300);
    // The two places round differently where an edge grazes a pixel's middle.
    expect(result.samePose?.pixels).toBeLessThan((result.drawn ?? 0) / 100);
    expect(result.moves).toBeGreaterThan(100);
  });
});

test('each of two views is drawn in its own part of the framebuffer with its own projection', async () => {
  const result = await page.call<{ apart: number }>('views');
  expect(result).toMatchObject({ left: SAME, right: SAME, outside: 0, error: 0 });
  expect(result.apart).toBeGreaterThan(100);
});

test('values are seen in the next frame and compile nothing; parts and lists come and go', async () => {
  expect(await page.call('live')).toEqual({
    first: [255, 0, 0, 255],
    green: [0, 128, 0, 255],
    hidden: [0, 0, 0, 0],
    behind: [0, 0, 0, 0],
    faded: [0, 51, 0, 102],
    gone: [0, 0, 0, 0],
    recompiled: 0,
    error: 0,
  });
});

test('nothing that others leave in the GL state is seen, and the framebuffer stays bound', async () => {
  const result = await page.call<{ drawn: number }>('state');
  expect(result).toMatchObject({ upset: SAME, late: SAME, bound: true, scissor: false, error: 0 });
  expect(result.drawn).toBeGreaterThan(1000);
});

test('the canvas is a target like any other', async () => {
  expect(await page.call('canvas')).toEqual({ left: [128, 0, 0, 255], right: [0, 0, 0, 0], error: 0 });
});

test('the neutral surroundings make a white matt ball as bright as they are, and no metal black', async () => {
  const { mean, fromAbove, fromBelow, darkestMetal, brightestMetal } = await page.call<Record<string, number>>('surroundings');
  expect(mean).toBeCloseTo(0.5, 2);
  expect(fromAbove).toBeGreaterThan(1.2 * (fromBelow ?? 0));
  expect(darkestMetal).toBeGreaterThan(0.05);
  expect(brightestMetal).toBeGreaterThan(3 * (darkestMetal ?? 0));
});
