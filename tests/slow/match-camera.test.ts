import { readFile } from 'node:fs/promises';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { createRandom } from '../../export/runtime/random.ts';
import { PAGE, paint } from '../browser/glsl-kit.ts';
import { applyShader, type Params } from '../browser/shader-library-kit.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { countDifferent } from '../support/pixels.ts';
import { describeWithData } from '../support/shared-data.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, PAGE);
});
afterAll(async () => {
  expect(page.errors).toEqual([]);
  await page.close();
});

const WIDTH = 480;
const HEIGHT = 270;

/** A layer that is laid over the camera's `camera`. */
function match(drawn: RgbaImage, camera: RgbaImage, params: Params = {}): Promise<RgbaImage> {
  return applyShader(page, 'operators/match-camera.fs', { drawn, camera }, params);
}

/** Box and Muller's way to normally distributed numbers. */
function createNormal(seed: number): () => number {
  const { next } = createRandom(seed, 'noise');
  return () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
}

/** Abramowitz and Stegun 7.1.26, to 1.5e-7. */
function erf(x: number): number {
  const t = 1 / (1 + 0.3275911 * Math.abs(x));
  const poly = ((((1.061405429 * t - 1.453152027) * t + 1.421413741) * t - 0.284496736) * t + 0.254829592) * t;
  return Math.sign(x) * (1 - poly * Math.exp(-x * x));
}

/**
 * A room of shaded walls and leaning edges, blurred by a Gaussian of `blurPx` and with noise of a standard deviation per channel, in
 * steps of 8 bits.
 */
function room(blurPx: number, noise: readonly [number, number, number] = [0, 0, 0]): RgbaImage {
  const normal = createNormal(7);
  return paint(WIDTH, HEIGHT, (x, y) => {
    // Stripes 90 px wide, whose sides lean.
    const along = (x + 0.35 * y) / 90;
    const away = (along - Math.round(along)) * 90 * Math.cos(Math.atan(0.35)) * (Math.round(along) % 2 === 0 ? 1 : -1);
    const edge = blurPx > 0 ? 0.5 * (1 + erf(away / (blurPx * Math.SQRT2))) : away > 0 ? 1 : 0;
    const wall = 70 + 90 * edge + 20 * (y / HEIGHT);
    const [r, g, b] = noise.map((sigma, c) => Math.min(Math.max(Math.round(wall + 6 * c + sigma * normal()), 0), 255));
    return [r ?? 0, g ?? 0, b ?? 0, 255];
  });
}

/** Gray on the left of an upright edge between two pixels, and nothing on its right. */
const HALF = paint(WIDTH, HEIGHT, (x) => (x < WIDTH / 2 ? [128, 128, 128, 255] : [0, 0, 0, 0]));

/** Standard deviation of each channel from `left` to `right`, and how much a pixel has in common with its neighbor, from -1 to 1. */
function grainOf(picture: RgbaImage, left: number, right: number): { readonly sigma: readonly number[]; readonly neighbors: number } {
  const columns = right - left;
  const valuesOf = (c: number) =>
    Float64Array.from(
      { length: columns * picture.height },
      (_, i) => pixelAt(picture, left + (i % columns), Math.floor(i / columns))[c] ?? 0,
    );
  const fromMean = [0, 1, 2].map((c) => {
    const values = valuesOf(c);
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    return values.map((value) => value - mean);
  });
  const sigma = fromMean.map((values) => Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length));
  const [red = new Float64Array()] = fromMean;
  const together = red.reduce((sum, value, i) => sum + (i % columns === 0 ? 0 : value * (red[i - 1] ?? 0)), 0) / red.length;
  return { sigma, neighbors: together / (sigma[0] ?? 1) ** 2 };
}

/** Standard deviation of the slope of alpha across the edge of `HALF`, in pixels, over the rows in the middle. */
function softnessOf(picture: RgbaImage): number {
  let weight = 0;
  let sum = 0;
  let squares = 0;
  for (let y = 100; y < 170; y++) {
    for (let x = 200; x < 280; x++) {
      const slope = pixelAt(picture, x, y)[3] - pixelAt(picture, x + 1, y)[3];
      weight += slope;
      sum += slope * x;
      squares += slope * x * x;
    }
  }
  return Math.sqrt(squares / weight - (sum / weight) ** 2);
}

test.each([
  [1, [0, 0, 0]],
  [1.5, [4, 4, 4]],
  [2.5, [5, 2.5, 3]],
  [4, [0, 0, 0]],
  [1, [12, 12, 12]],
] as const)('a blur of %d px and a noise of %j steps are measured, and what is drawn has both', async (blurPx, noise) => {
  const made = await match(HALF, room(blurPx, noise));
  const { sigma, neighbors } = grainOf(made, 0, 200);
  sigma.forEach((found, c) => {
    // Within a tenth, and half a step.
    expect(Math.abs(found - (noise[c] ?? 0))).toBeLessThan(0.1 * (noise[c] ?? 0) + 0.5);
  });
  if (noise[0] > 0) expect(Math.abs(neighbors)).toBeLessThan(0.05);
  // Within a seventh, and a fiftieth of a pixel per step of noise, which makes edges seem sharper than they are.
  expect(Math.abs(softnessOf(made) - blurPx)).toBeLessThan(0.14 * blurPx + 0.02 * noise[0]);
  // What was empty beyond the blur is empty.
  expect(grainOf(made, 280, WIDTH).sigma).toEqual([0, 0, 0]);
});

test('a sharp picture without noise, and one without an edge, leave what is drawn as it is', async () => {
  expect(countDifferent(await match(HALF, room(0)), HALF, 8).pixels).toBe(0);
  const wall = paint(WIDTH, HEIGHT, (_, y) => [90 + (y >> 3), 90, 90, 255]);
  expect(countDifferent(await match(HALF, wall), HALF, 1).pixels).toBe(0);
});

test('the controls turn both down', async () => {
  const camera = room(2.5, [6, 6, 6]);
  expect(countDifferent(await match(HALF, camera, { blur: 0, grain: 0 }), HALF).pixels).toBe(0);
  const [half = 0] = grainOf(await match(HALF, camera, { grain: 0.5 }), 0, 200).sigma;
  expect(half).toBeGreaterThan(2.6);
  expect(half).toBeLessThan(3.4);
});

describeWithData('over photographs', 'images/astronaut.png', (path) => {
  test('noise that is added to one is found again', async () => {
    const whole = decodeImage(await readFile(path));
    const sigmaWith = async (sigma: number) => {
      const normal = createNormal(3);
      const camera = paint(480, 480, (x, y) => {
        const [r, g, b] = pixelAt(whole, x + 16, y + 16);
        const [red = 0, green = 0, blue = 0] = [r, g, b].map((v) => Math.min(Math.max(Math.round(v + sigma * normal()), 0), 255));
        return [red, green, blue, 255];
      });
      const gray = paint(480, 480, () => [128, 128, 128, 255]);
      return grainOf(await match(gray, camera, { blur: 0 }), 0, 480).sigma[1] ?? 0;
    };
    const own = await sigmaWith(0);
    // Of the photograph itself there is little.
    expect(own).toBeLessThan(2.5);
    for (const added of [6, 12]) {
      const expected = Math.hypot(own, added);
      const found = await sigmaWith(added);
      expect(found / expected).toBeGreaterThan(0.85);
      expect(found / expected).toBeLessThan(1.15);
    }
  });
});
