import { beforeAll, describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { PAGE, paint } from './glsl-kit.ts';
import { applyShader, type Params } from './shader-library-kit.ts';

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

/** Noise from −3 to 3 without a pattern, another for each seed. */
const noiseOf = (seed: number) => (x: number, y: number) =>
  Math.floor(((Math.sin(x * 12.9898 + y * 78.233 + seed) * 43758.5453) % 1) * 3.5);

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
});

test('the noise of a camera leaves strokes in place', async () => {
  const name = 'pencil-drawing';
  const params = PLAIN;
  const drawn = await applyShader(page, `filters/${name}.fs`, { inputImage: testImage(noiseOf(0)) }, params);
  const noisy = await applyShader(page, `filters/${name}.fs`, { inputImage: testImage(noiseOf(1)) }, params);
  const apart = (a: RgbaImage, b: RgbaImage, step: number) =>
    mean(grayArea(1), (x, y) => Math.abs(pixelAt(a, x, y)[0] - pixelAt(b, x + step, y + step)[0]) / 255);
  const strokes = apart(drawn, drawn, 2);
  expect(strokes).toBeGreaterThan(0.05);
  expect(apart(drawn, noisy, 0)).toBeLessThan(0.1 * strokes);
});
