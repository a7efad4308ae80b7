import { readFile } from 'node:fs/promises';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { decodePicture, type Picture, pixelAt } from '../support/picture.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { describeWithData } from '../support/shared-data.ts';
import { PAGE, paint } from './glsl-kit.ts';
import { applyShader, expectedPicture, type Params } from './shader-library-kit.ts';

/** Half a step of rounding on either side and one for single precision and for the linear filtering of textures. */
const TOLERANCE = 2;

/** What `expected/filters.py` computes with the same values, by filter and case. */
const CASES: Readonly<Record<string, Readonly<Record<string, Params>>>> = {
  grey: { full: {}, part: { amount: 0.4 } },
  'luminance-variation': { contrast: {}, dark: { brightness: -0.2, contrast: 0.8, gamma: 1.7 } },
  'chrominance-variation': { turned: {}, shifted: { saturation: 0.6, rotation: -1, blueYellow: 0.1, redCyan: -0.2 } },
  vignette: { ellipse: {}, circle: { amount: 0.9, start: 0.2, softness: 0.3, roundness: 1, tint: [1, 0.9, 0.6, 1] } },
  posterize: { 4: {}, 7: { levels: 7 } },
  'chroma-key': { green: {}, red: { keyColor: [0.8, 0.2, 0.1, 1], tolerance: 0.1, softness: 0.2, spill: 1 } },
  'skin-mask': { soft: {}, cut: { softness: 20, widen: 3, show: 1 } },
  'hdr-exposure': { long: {}, kept: { stops: 2.5, highlights: 1 }, short: { stops: -2 } },
  'film-grain': { grey: {}, colour: { amount: 0.15, size: 3, color: 0.7, midtones: 1 } },
  halftone: { ink: {}, colour: { size: 13.5, angle: 0.3, pictureColors: 1 } },
  pixelate: { 8: { size: 8 }, 13: { size: 13 } },
  swirl: { left: { angle: 1.5, radius: 60 }, right: { angle: -2, radius: 200 } },
  tile: { plain: { columns: 4, rows: 2 }, mirrored: { columns: 2, rows: 8, mirror: 1 } },
  'radial-blur': { middle: {}, corner: { amount: 0.3, center: [0.2, 0.9] } },
  'spin-blur': { middle: {}, corner: { angle: 0.5, center: [0.2, 0.9] } },
  kuwahara: { 5: {}, soft: { radius: 3, sharpness: 2 } },
  bilateral: { 6: {}, wide: { radius: 10, colorRange: 0.6 } },
  'difference-of-gaussians': { ink: {}, over: { radius: 2.4, strength: 40, level: 0.5, hardness: 10, overPicture: 1 } },
  bloom: { wide: {}, near: { level: 0.1, radius: 3, strength: 2 } },
};

const EACH = Object.entries(CASES).flatMap(([filter, cases]) =>
  Object.entries(cases).map(([name, params]) => [filter, name, params] as const),
);

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, PAGE);
});
afterAll(async () => {
  expect(page.errors).toEqual([]);
  await page.close();
});

function apply(filter: string, inputImage: Picture, params?: Params): Promise<Picture> {
  return applyShader(page, `filters/${filter}.fs`, { inputImage }, params);
}

/** The part of the photograph that `expected/filters.py` uses. */
async function photograph(path: string): Promise<Picture> {
  const whole = decodePicture(await readFile(path));
  return paint(256, 256, (x, y) => pixelAt(whole, x + 128, y));
}

/** The pixels that it keeps of the result. */
function samplesOf(picture: Picture): Picture {
  const every = 8;
  const [left, top] = [5, 7];
  const count = (size: number, first: number) => Math.ceil((size - first) / every);
  return paint(count(picture.width, left), count(picture.height, top), (x, y) => pixelAt(picture, left + x * every, top + y * every));
}

describe('over the generated picture', () => {
  test.each(EACH)('%s (%s) is what other software computes', async (filter, name, params) => {
    const drawn = await apply(filter, await expectedPicture('generated'), params);
    const file = `generated-${filter}-${name}`;
    await expectSamePixels(file, drawn, await expectedPicture(file), { tolerance: TOLERANCE });
  });
});

describeWithData('over a photograph', 'images/astronaut.png', (path) => {
  let picture: Picture;
  beforeAll(async () => {
    picture = await photograph(path);
  });

  test.each(EACH)('%s (%s) is what other software computes', async (filter, name, params) => {
    const drawn = await apply(filter, picture, params);
    const file = `astronaut-${filter}-${name}`;
    await expectSamePixels(file, samplesOf(drawn), await expectedPicture(file), { tolerance: TOLERANCE });
  });
});

/** Controls that change something by default, at the value that changes nothing. */
const IDENTITIES: Readonly<Record<string, Params>> = {
  grey: { amount: 0 },
  'luminance-variation': { contrast: 1 },
  'chrominance-variation': { rotation: 0 },
  vignette: { amount: 0 },
  posterize: { amount: 0 },
  'hdr-exposure': { stops: 0 },
  'film-grain': { amount: 0 },
  pixelate: { size: 1 },
  swirl: { angle: 0 },
  tile: { columns: 1, rows: 1 },
  'radial-blur': { amount: 0 },
  'spin-blur': { angle: 0 },
  kuwahara: { radius: 0 },
  bilateral: { radius: 0 },
  bloom: { strength: 0 },
};

test.each(Object.entries(IDENTITIES))('%s changes nothing at its identity', async (filter, params) => {
  const picture = await expectedPicture('generated');
  await expectSamePixels(`identity-${filter}`, await apply(filter, picture, params), picture, { tolerance: 1 });
});
