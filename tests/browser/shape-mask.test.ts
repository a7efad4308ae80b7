import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { PAGE, paint } from './glsl-kit.ts';
import { applyShader, type Params } from './shader-library-kit.ts';

type Point = readonly [x: number, y: number];

const page = useModule(PAGE);

const RECTANGLE = 0;
const ELLIPSE = 1;
const POLYGON = 2;

/** Not square, so that a fraction of the width is not one of the height. */
const LANDSCAPE = { width: 160, height: 90 };
const PORTRAIT = { width: 90, height: 160 };

function draw(params: Params, size = LANDSCAPE): Promise<RgbaImage> {
  return applyShader(page, 'generators/shape-mask.fs', {}, params, size);
}

const alphas = ({ data }: RgbaImage) => [...data].filter((_, i) => i % 4 === 3);
const areaOf = (image: RgbaImage) => alphas(image).reduce((sum, alpha) => sum + alpha / 255, 0);
const row = (image: RgbaImage, y: number) => Array.from({ length: image.width }, (_, x) => pixelAt(image, x, y)[3]);
const column = (image: RgbaImage, x: number) => Array.from({ length: image.height }, (_, y) => pixelAt(image, x, y)[3]);
const shown = (line: readonly number[]) => line.filter((alpha) => alpha > 127).length;

test('a rectangle is white inside and transparent outside, in fractions of the height of the layer', async () => {
  const image = await draw({ shape: RECTANGLE, center: [0.25, 0.5], size: [0.4, 0.2] });
  // 36 × 18 pixels around (40, 45).
  for (const [x, y] of [
    [22, 36],
    [57, 53],
    [40, 45],
  ] as const)
    expect(pixelAt(image, x, y)).toEqual([255, 255, 255, 255]);
  for (const [x, y] of [
    [21, 45],
    [58, 45],
    [40, 35],
    [40, 54],
  ] as const)
    expect(pixelAt(image, x, y)[3]).toBe(0);
  expect(areaOf(image)).toBe(36 * 18);
});

test.each([
  ['landscape', LANDSCAPE],
  ['portrait', PORTRAIT],
])('a circle is round in %s', async (_, size) => {
  const image = await draw({ shape: ELLIPSE, size: [0.5, 0.5] }, size);
  const diameter = size.height / 2;
  expect(shown(row(image, size.height / 2))).toBeCloseTo(diameter, -0.5);
  expect(shown(column(image, size.width / 2))).toBeCloseTo(diameter, -0.5);
  expect(areaOf(image) / ((Math.PI * diameter * diameter) / 4)).toBeCloseTo(1, 2);
});

test('the feather is as wide as it says, half of it outside', async () => {
  const image = await draw({ shape: RECTANGLE, size: [1, 0.5], feather: 20 / 90 });
  const line = row(image, 45);
  // The left side is at x = 35; pixels have their centers at halves.
  expect([line[34], line[35]].map((alpha) => Math.abs((alpha ?? 0) - 127.5))).toEqual([expect.closeTo(9.5, 0), expect.closeTo(9.5, 0)]);
  expect(line.slice(0, 25)).toEqual(Array.from({ length: 25 }, () => 0));
  expect(line.slice(45, 115)).toEqual(Array.from({ length: 70 }, () => 255));
  const rising = line.slice(26, 44);
  expect(rising).toEqual([...rising].sort((a, b) => a - b));
  expect(new Set(rising).size).toBe(rising.length);
});

/** Corners of a polygon that has the border of a shape, in the axes of the shape. */
function borderOf({ shape = 0, size = [], corner = 0, sides = 6 }: Params): Point[] {
  const [width = 0, height = 0] = size as readonly number[];
  const around = (count: number, at: (c: number, s: number) => Point) =>
    Array.from({ length: count }, (_, i) => {
      const turn = Math.PI / 2 + (2 * Math.PI * (i + (shape === POLYGON ? 0 : 0.5))) / count;
      return at(Math.cos(turn), Math.sin(turn));
    });
  if (shape !== RECTANGLE) return around(shape === POLYGON ? Number(sides) : 400, (c, s) => [(c * width) / 2, (s * height) / 2]);
  const radius = Math.min(Number(corner), width / 2, height / 2);
  const [inX, inY] = [width / 2 - radius, height / 2 - radius];
  return around(radius === 0 ? 4 : 200, (c, s) => [Math.sign(c) * inX + radius * c, Math.sign(s) * inY + radius * s]);
}

/** Even-odd rule. */
function isInside(border: readonly Point[], [x, y]: Point): boolean {
  let inside = false;
  border.forEach(([x1, y1], i) => {
    const [x2, y2] = border[(i + 1) % border.length] ?? [0, 0];
    if (y1 > y !== y2 > y && x < x1 + ((y - y1) / (y2 - y1)) * (x2 - x1)) inside = !inside;
  });
  return inside;
}

function distanceToSide([x, y]: Point, [fromX, fromY]: Point, [toX, toY]: Point): number {
  const [sideX, sideY] = [toX - fromX, toY - fromY];
  const along = Math.min(Math.max(((x - fromX) * sideX + (y - fromY) * sideY) / (sideX ** 2 + sideY ** 2), 0), 1);
  return Math.hypot(x - fromX - along * sideX, y - fromY - along * sideY);
}

/** Coverage by the distance to the nearest side. */
function expected(params: Params, { width, height }: typeof LANDSCAPE): RgbaImage {
  const border = borderOf(params);
  const [centerX = 0.5, centerY = 0.5] = (params.center ?? []) as readonly number[];
  const [c, s] = [Math.cos(Number(params.rotation ?? 0)), Math.sin(Number(params.rotation ?? 0))];
  const soft = Math.max(Number(params.feather ?? 0), 1 / height);
  return paint(width, height, (x, y) => {
    const [dx, dy] = [(x + 0.5 - centerX * width) / height, (height - y - 0.5 - centerY * height) / height];
    const point: Point = [c * dx + s * dy, c * dy - s * dx];
    const distances = border.map((from, i) => distanceToSide(point, from, border[(i + 1) % border.length] ?? from));
    const away = Math.min(...distances) * (isInside(border, point) ? -1 : 1);
    const t = Math.min(Math.max(0.5 - away / soft, 0), 1);
    const alpha = Math.round(255 * t * t * (3 - 2 * t));
    return [alpha, alpha, alpha, alpha];
  });
}

test.each([
  ['rotated rectangle', { shape: RECTANGLE, center: [0.6, 0.4], size: [0.7, 0.4], rotation: 0.5, feather: 0.3 }],
  ['rounded rectangle', { shape: RECTANGLE, size: [0.8, 0.5], corner: 0.15, rotation: -0.3, feather: 0.2 }],
  ['flat ellipse', { shape: ELLIPSE, center: [0.4, 0.55], size: [1.2, 0.3], rotation: 0.7, feather: 0.25 }],
  ['upright ellipse', { shape: ELLIPSE, size: [0.4, 0.7], feather: 0.3 }],
  ['triangle', { shape: POLYGON, sides: 3, size: [0.8, 0.6], feather: 0.2 }],
  ['heptagon', { shape: POLYGON, sides: 7, center: [0.5, 0.45], size: [0.7, 0.9], rotation: 1, feather: 0.15 }],
])('the soft edge of a %s follows the distance to its border', async (name, params) => {
  const size = { width: 96, height: 54 };
  const wanted = expected(params, size);
  const drawn = await draw(params, size);
  // Straight white with this alpha, premultiplied.
  await expectSamePixels(`shape-mask-${name.replace(' ', '-')}`, drawn, wanted, { tolerance: 3 });
});

test('inverted, it is the rest of the image; at size 0 there is nothing', async () => {
  const params = { shape: ELLIPSE, size: [0.6, 0.4], rotation: 0.3, feather: 0.1 };
  const [inside, outside] = [alphas(await draw(params)), alphas(await draw({ ...params, invert: 1 }))];
  inside.forEach((alpha, i) => {
    expect(Math.abs(255 - alpha - (outside[i] ?? 0))).toBeLessThanOrEqual(1);
  });
  for (const shape of [RECTANGLE, ELLIPSE, POLYGON]) {
    expect(areaOf(await draw({ shape, size: [0, 0] }))).toBe(0);
    expect(areaOf(await draw({ shape, size: [0.5, 0], feather: 0.1 }))).toBe(0);
  }
});
