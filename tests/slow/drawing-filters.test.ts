import { beforeAll, describe, expect, test } from '@jest/globals';
import { PAGE, paint } from '../browser/glsl-kit.ts';
import { applyShader, noiseOf, type Params } from '../browser/shader-library-kit.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';

const page = useModule(PAGE);

/** An area of the test image: left, top, width, height in pixels, without the margin where directions see the neighboring area. */
interface Area {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

const WIDTH = 512;
const HEIGHT = 384;
const MARGIN = 16;
const GRAYS = [64, 128, 191];
const GRAY_WIDTH = Math.floor(WIDTH / GRAYS.length);
const GRAY_HEIGHT = 256;
const area = (left: number, top: number, width: number, height: number): Area => ({
  left: left + MARGIN,
  top: top + MARGIN,
  width: width - 2 * MARGIN,
  height: height - 2 * MARGIN,
});
const grayArea = (i: number) => area(i * GRAY_WIDTH, 0, GRAY_WIDTH, GRAY_HEIGHT);
const STRIPES = area(0, GRAY_HEIGHT, 192, 128);
/** Light gray against white: the edge is at x = 256. */
const EDGE = area(192, GRAY_HEIGHT, 128, 128);
const EDGE_X = 256;
const TRANSPARENT_X = 320;

/** Three grays over stripes that fall to the right, an edge, and nothing. `noise` is added to opaque pixels, in 8-bit steps. */
function testImage(noise: (x: number, y: number) => number = () => 0): RgbaImage {
  return paint(WIDTH, HEIGHT, (x, y) => {
    if (y >= GRAY_HEIGHT && x >= TRANSPARENT_X) return [0, 0, 0, 0];
    const light =
      y < GRAY_HEIGHT
        ? (GRAYS[Math.min(Math.floor(x / GRAY_WIDTH), GRAYS.length - 1)] ?? 0)
        : x < 192
          ? 128 + 40 * Math.sin((x - y) / 4)
          : x < EDGE_X
            ? 200
            : 255;
    const value = Math.min(Math.max(Math.round(light + noise(x, y)), 0), 255);
    return [value, value, value, 255];
  });
}

/** The mean over an area of a function of a pixel's position. */
function mean({ left, top, width, height }: Area, of: (x: number, y: number) => number): number {
  let sum = 0;
  for (let y = top; y < top + height; y++) for (let x = left; x < left + width; x++) sum += of(x, y);
  return sum / (width * height);
}

/** Some hundred strokes are in each gray, so their mean is a random sample. */
const TONE_ERROR = 0.06;

/** Black on white. */
const PLAIN: Params = { paperColor: [1, 1, 1, 1], angle: Math.PI / 4, lines: 1 };
/** The mean brightness that pencil and pen ask for on a gray: the exponent is 2^(1.4 − 2 × 0.5). */
const pressed = (light: number) => 1 - (1 - light) ** (2 ** 0.4);
const DRAWINGS: readonly { readonly name: string; readonly params: Params; readonly asked: (light: number) => number }[] = [
  { name: 'pencil-drawing', params: { ...PLAIN, pencilColor: [0, 0, 0, 1] }, asked: pressed },
  { name: 'hatched-drawing', params: { ...PLAIN, inkColor: [0, 0, 0, 1] }, asked: pressed },
  {
    name: 'charcoal-drawing',
    params: { ...PLAIN, charcoalColor: [0, 0, 0, 1], roughness: 0, strokePx: 1.5, lengthPx: 24 },
    asked: (light) => light ** 1.8 / (light ** 1.8 + (1 - light) ** 1.8),
  },
];

describe.each(DRAWINGS)('$name', ({ name, params, asked }) => {
  let drawn: RgbaImage;
  const red = (image: RgbaImage, x: number, y: number) => pixelAt(image, x, y)[0] / 255;
  /** Mean absolute difference between pixels that far apart: small along strokes, large across them. */
  const roughness = (of: Area, dx: number, dy: number) => mean(of, (x, y) => Math.abs(red(drawn, x, y) - red(drawn, x + dx, y + dy)));

  beforeAll(async () => {
    drawn = await applyShader(page, `filters/${name}.fs`, { inputImage: testImage() }, params);
  });

  test.each(GRAYS.map((gray, i) => [gray, i] as const))('on a gray of %d has the tone that it asks for in the mean', (gray, i) => {
    const found = mean(grayArea(i), (x, y) => red(drawn, x, y));
    expect(Math.abs(found - asked(gray / 255))).toBeLessThan(TONE_ERROR);
  });

  test('draws strokes at its angle in flat areas', () => {
    expect(roughness(grayArea(2), 2, -2)).toBeLessThan(0.7 * roughness(grayArea(2), 2, 2));
  });

  test('draws strokes along stripes in another direction', () => {
    // Rows are from the top: where x − y is constant, stripes fall to the right, across the angle.
    expect(roughness(STRIPES, 2, 2)).toBeLessThan(0.7 * roughness(STRIPES, 2, -2));
  });

  test('draws a line along an edge', () => {
    const column = (x: number) => mean({ ...EDGE, left: x, width: 1 }, (_, y) => red(drawn, x, y));
    const line = Math.min(...[-4, -3, -2, -1].map((dx) => column(EDGE_X + dx)));
    expect(line).toBeLessThan(0.7 * column(230));
    expect(column(280)).toBeGreaterThan(0.95);
  });

  test('draws nothing where the layer is transparent', () => {
    expect(pixelAt(drawn, 400, 320)).toEqual([0, 0, 0, 0]);
  });

  test('leaves strokes in place under the noise of a camera', async () => {
    const noisy = (seed: number) => applyShader(page, `filters/${name}.fs`, { inputImage: testImage(noiseOf(seed)) }, params);
    const [a, b] = [await noisy(0), await noisy(1)];
    const apart = (other: RgbaImage, step: number) => mean(grayArea(1), (x, y) => Math.abs(red(a, x, y) - red(other, x + step, y + step)));
    const strokes = apart(a, 2);
    expect(strokes).toBeGreaterThan(0.05);
    expect(apart(b, 0)).toBeLessThan(0.1 * strokes);
  });
});

/** Three gray areas that meet at straight edges, over a ramp from black to white; transparent at the right. */
const SMALL = { width: 256, height: 192 };
const SMALL_TRANSPARENT_X = 240;
/** Multiples of a fifth, so that pictures of five steps have no other tone. */
const FIFTHS = [51, 153, 204] as const;
const BAND = 80;
const RAMP_TOP = 128;
/** Middle of each gray area, without the margin of its neighbors. */
const band = (i: number): Area => ({ left: i * BAND + 20, top: 20, width: BAND - 40, height: RAMP_TOP - 40 });

function smallImage(noise: (x: number, y: number) => number = () => 0): RgbaImage {
  return paint(SMALL.width, SMALL.height, (x, y) => {
    if (x >= SMALL_TRANSPARENT_X) return [0, 0, 0, 0];
    const light = y < RAMP_TOP ? (FIFTHS[Math.floor(x / BAND)] ?? 0) : (255 * x) / (SMALL_TRANSPARENT_X - 1);
    const value = Math.min(Math.max(Math.round(light + noise(x, y)), 0), 255);
    return [value, value, value, 255];
  });
}

const redAt = (image: RgbaImage, x: number, y: number) => pixelAt(image, x, y)[0] / 255;
/** Each image is drawn once for all tests. */
const drawnSmall = new Map<string, Promise<RgbaImage>>();
function small(name: string, params: Params = {}, seed: number | null = null): Promise<RgbaImage> {
  const key = JSON.stringify([name, params, seed]);
  const inputImage = smallImage(seed === null ? undefined : noiseOf(seed));
  const image = drawnSmall.get(key) ?? applyShader(page, `filters/${name}.fs`, { inputImage }, params);
  drawnSmall.set(key, image);
  return image;
}

/** What the three have in common: a picture of even areas stays what it is where nothing is added to it. */
const PAINTINGS: readonly { readonly name: string; readonly bare: Params }[] = [
  { name: 'comic-drawing', bare: { levels: 5, lines: 0 } },
  { name: 'watercolor', bare: { washes: 5, dilution: 0, borders: 0, pigment: 0, grain: 0, wobblePx: 0, paperColor: [1, 1, 1, 1] } },
  { name: 'oil-painting', bare: { variety: 0, relief: 0 } },
];

describe.each(PAINTINGS)('$name', ({ name, bare }) => {
  let painted: RgbaImage;
  let plain: RgbaImage;

  beforeAll(async () => {
    painted = await small(name);
    plain = await small(name, bare);
  });

  test('leaves even areas as they are, where nothing is added to them', () => {
    FIFTHS.forEach((gray, i) => {
      expect(mean(band(i), (x, y) => Math.abs(redAt(plain, x, y) * 255 - gray))).toBeLessThan(1.5);
    });
  });

  test('keeps the order of tones, and edges where they are', () => {
    const tones = FIFTHS.map((_, i) => mean(band(i), (x, y) => redAt(painted, x, y)));
    expect(tones[1]).toBeGreaterThan((tones[0] ?? 1) + 0.2);
    expect(tones[2]).toBeGreaterThan((tones[1] ?? 1) + 0.08);
    const column = (x: number) => mean({ ...band(0), left: x, width: 1 }, (_, y) => redAt(plain, x, y) * 255);
    expect(column(BAND - 5)).toBeLessThan(80);
    expect(column(BAND + 5)).toBeGreaterThan(125);
  });

  test('changes little with the noise of a camera', async () => {
    const noisy = await small(name, {}, 1);
    const all = { left: 0, top: 0, width: SMALL_TRANSPARENT_X, height: SMALL.height };
    // The noise itself has a mean of 1.5 steps of 255.
    expect(mean(all, (x, y) => Math.abs(redAt(painted, x, y) - redAt(noisy, x, y)) * 255)).toBeLessThan(2.5);
  });

  test('paints nothing where the layer is transparent', () => {
    expect(pixelAt(painted, SMALL_TRANSPARENT_X + 12, 60)).toEqual([0, 0, 0, 0]);
  });
});

describe('comic-drawing', () => {
  test('draws a ramp in tones that are multiples of one step, each of them', async () => {
    const steps = 4;
    const drawn = await small('comic-drawing', { levels: steps, lines: 0, shadows: 0 });
    const ramp: Area = { left: 4, top: RAMP_TOP + 24, width: SMALL_TRANSPARENT_X - 20, height: 24 };
    const distance = (x: number, y: number) => Math.abs(redAt(drawn, x, y) * steps - Math.round(redAt(drawn, x, y) * steps)) / steps;
    expect(mean(ramp, (x, y) => (distance(x, y) < 0.02 ? 1 : 0))).toBeGreaterThan(0.85);
    for (let k = 0; k <= steps; k++) {
      expect(mean(ramp, (x, y) => (Math.abs(redAt(drawn, x, y) - k / steps) < 0.02 ? 1 : 0))).toBeGreaterThan(0.04);
    }
  });

  test('gives a tone between two steps by dots of the darker one', async () => {
    const drawn = await small('comic-drawing', { levels: 4, lines: 0, shadows: 1 });
    // 153 / 255 is between 2 / 4 and 3 / 4.
    const isStep = (value: number) => (Math.min(Math.abs(value - 0.5), Math.abs(value - 0.75)) < 0.06 ? 1 : 0);
    expect(mean(band(1), (x, y) => redAt(drawn, x, y))).toBeCloseTo(0.6, 1);
    expect(mean(band(1), (x, y) => isStep(redAt(drawn, x, y)))).toBeGreaterThan(0.5);
  });

  test('draws an ink line on the dark side of an edge', async () => {
    const drawn = await small('comic-drawing');
    const beside = [1, 2, 3].map((dx) => mean({ ...band(1), left: 2 * BAND - dx, width: 1 }, (_, y) => redAt(drawn, 2 * BAND - dx, y)));
    expect(Math.min(...beside)).toBeLessThan(0.45);
  });
});

test('watercolor gathers pigment on the dark side of an edge, and leaves white paper', async () => {
  const params = { pigment: 0, grain: 0, wobblePx: 0, washes: 5, dilution: 0, paperColor: [1, 1, 0.8, 1] };
  const drawn = await small('watercolor', params);
  const column = (x: number) => mean({ ...band(0), left: x, width: 1 }, (_, y) => redAt(drawn, x, y));
  expect(Math.min(column(2 * BAND - 2), column(2 * BAND - 3))).toBeLessThan(column(2 * BAND - 30) - 0.03);
  const [r, g, b] = pixelAt(drawn, SMALL_TRANSPARENT_X - 4, RAMP_TOP + 40);
  expect(r).toBeGreaterThan(250);
  expect(g).toBeGreaterThan(250);
  expect(Math.abs(b - 204)).toBeLessThan(5);
});

test('oil-painting has strokes along the angle in even areas, and relief that is lit from the top left', async () => {
  const drawn = await small('oil-painting', { angle: Math.PI / 4, follow: 0, detail: 0, variety: 1, relief: 0 });
  const roughness = (dx: number, dy: number) => mean(band(1), (x, y) => Math.abs(redAt(drawn, x, y) - redAt(drawn, x + dx, y + dy)));
  expect(roughness(2, -2)).toBeLessThan(0.75 * roughness(2, 2));
  const flat = await small('oil-painting', { variety: 0, relief: 0 });
  const raised = await small('oil-painting', { variety: 0, relief: 1 });
  const differences = (from: number, to: number) =>
    mean(band(1), (x, y) => {
      const lit = redAt(raised, x, y) - redAt(flat, x, y);
      return lit > from && lit < to ? 1 : 0;
    });
  expect(differences(0.02, 1)).toBeGreaterThan(0.1);
  expect(differences(-1, -0.02)).toBeGreaterThan(0.1);
});
