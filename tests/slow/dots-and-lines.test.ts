import { describe, expect, test } from '@jest/globals';
import { PAGE, paint } from '../browser/glsl-kit.ts';
import { applyShader, noiseOf, type Params } from '../browser/shader-library-kit.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';

const page = useModule(PAGE);

const WIDTH = 360;
const HEIGHT = 120;
/** Light grays to black; the rightmost area is transparent. */
const TONES = [230, 191, 128, 64, 0];
const AREA = WIDTH / (TONES.length + 1);
const MARGIN = 12;

const tones = (seed = 0) =>
  paint(WIDTH, HEIGHT, (x, y) => {
    const tone = TONES[Math.floor(x / AREA)];
    if (tone === undefined) return [0, 0, 0, 0];
    const value = Math.min(Math.max(tone + (seed === 0 ? 0 : noiseOf(seed)(x, y)), 0), 255);
    return [value, value, value, 255];
  });

/** The mean over the middle of an area of a function of a pixel's position. */
function mean(area: number, of: (x: number, y: number) => number): number {
  let [sum, count] = [0, 0];
  for (let y = MARGIN; y < HEIGHT - MARGIN; y++) {
    for (let x = Math.ceil(area * AREA) + MARGIN; x < (area + 1) * AREA - MARGIN; x++) {
      sum += of(x, y);
      count++;
    }
  }
  return sum / count;
}

const red = (image: RgbaImage, x: number, y: number) => pixelAt(image, x, y)[0] / 255;
const draw = (name: string, params: Params, seed = 0) => applyShader(page, `filters/${name}.fs`, { inputImage: tones(seed) }, params);

const INK: Params = { inkColor: [0, 0, 0, 1], paperColor: [1, 1, 1, 1] };
const DRAWINGS: readonly (readonly [name: string, params: Params])[] = [
  ['stipple', { ...INK, dotPx: 2.5 }],
  ['stipple', { ...INK, dotPx: 6, variety: 0 }],
  ['engraving', { ...INK, bow: 0, crossing: 0 }],
  ['engraving', { ...INK, bow: 1, crossing: 1, spacing: 4 }],
];

describe.each(DRAWINGS)('%s %j', (name, params) => {
  const drawn = () => draw(name, params);

  test('has the tones of the image in the mean, with paper and ink alone', async () => {
    const image = await drawn();
    const errors = TONES.map((tone, i) => Math.abs(mean(i, (x, y) => red(image, x, y)) - tone / 255));
    expect(Math.max(...errors)).toBeLessThan(0.04);
    // A gray pixel is one that an edge crosses.
    const mixed = mean(0, (x, y) => (red(image, x, y) > 0.02 && red(image, x, y) < 0.98 ? 1 : 0));
    expect(mixed).toBeLessThan(0.45);
  });

  test('draws nothing where the layer is transparent', async () => {
    expect(pixelAt(await drawn(), WIDTH - 20, 60)).toEqual([0, 0, 0, 0]);
  });

  test('stays in place under the noise of a camera', async () => {
    const [a, b] = [await draw(name, params, 1), await draw(name, params, 2)];
    const apart = (other: RgbaImage, step: number) => mean(1, (x, y) => Math.abs(red(a, x, y) - red(other, x + step, y + step)));
    expect(apart(a, 2)).toBeGreaterThan(0.15);
    expect(apart(b, 0)).toBeLessThan(0.15 * apart(a, 2));
  });
});

/** Sizes in pixels of the connected groups of ink that reach into the middle of an area. */
function groups(image: RgbaImage, area: number): number[] {
  const left = Math.ceil(area * AREA);
  const seen = new Set<number>();
  const sizes: number[] = [];
  const isInk = (x: number, y: number) => x >= left && x < left + AREA && y >= 0 && y < HEIGHT && red(image, x, y) < 0.5;
  for (let y = MARGIN; y < HEIGHT - MARGIN; y++) {
    for (let x = left + MARGIN; x < left + AREA - MARGIN; x++) {
      if (seen.has(y * WIDTH + x) || !isInk(x, y)) continue;
      const open = [[x, y]] as [number, number][];
      seen.add(y * WIDTH + x);
      let size = 0;
      for (let next = open.pop(); next !== undefined; next = open.pop()) {
        size++;
        for (const [dx, dy] of [
          [1, 0],
          [-1, 0],
          [0, 1],
          [0, -1],
        ] as const) {
          const [nx, ny] = [next[0] + dx, next[1] + dy];
          if (seen.has(ny * WIDTH + nx) || !isInk(nx, ny)) continue;
          seen.add(ny * WIDTH + nx);
          open.push([nx, ny]);
        }
      }
      sizes.push(size);
    }
  }
  return sizes;
}

test('stipple draws light tones as single dots of one size, about as many as the tone asks for', async () => {
  const sizes = groups(await draw('stipple', { ...INK, dotPx: 6, variety: 0 }), 0);
  const dot = Math.PI * 3 ** 2;
  const asked = ((1 - 230 / 255) * (AREA - 2 * MARGIN) * (HEIGHT - 2 * MARGIN)) / dot;
  expect(sizes.length / asked).toBeGreaterThan(0.8);
  expect(sizes.length / asked).toBeLessThan(1.6);
  // The newest dots are still growing.
  const whole = sizes.filter((size) => Math.abs(size - dot) < 0.4 * dot).length;
  expect(whole / sizes.length).toBeGreaterThan(0.6);
  expect(Math.max(...sizes)).toBeLessThan(1.4 * dot);
});

test('engraving draws lines at its angle and distance, wider in darker tones, and crosses dark ones alone', async () => {
  const image = await draw('engraving', { ...INK, angle: 0, bow: 0, crossing: 0, spacing: 8 });
  const profile = (area: number) => Array.from({ length: HEIGHT }, (_, y) => red(image, Math.floor((area + 0.5) * AREA), y) < 0.5);
  for (const [area, widthPx] of [
    [1, 2],
    [2, 4],
    [3, 6],
  ] as const) {
    const ink = profile(area);
    const starts = ink.flatMap((is, y) => (is && y > 0 && ink[y - 1] === false ? [y] : []));
    starts.slice(1).forEach((y, i) => {
      expect(y - (starts[i] ?? 0)).toBe(8);
    });
    const widths = starts.slice(0, -1).map((y) => ink.slice(y, y + 8).filter(Boolean).length);
    expect(widths.every((width) => Math.abs(width - widthPx) <= 1)).toBe(true);
    // Rows are even: no other line crosses them.
    expect(mean(area, (x, y) => Math.abs(red(image, x, y) - red(image, x + 1, y)))).toBeLessThan(0.002);
  }
  const crossed = await draw('engraving', { ...INK, angle: 0, bow: 0, crossing: 1, spacing: 8 });
  const along = (area: number) => mean(area, (x, y) => Math.abs(red(crossed, x, y) - red(crossed, x + 1, y)));
  expect(along(1)).toBeLessThan(0.002);
  expect(along(3)).toBeGreaterThan(0.05);
});

test('engraving bows its lines by the brightness: by 40 px from black to white', async () => {
  const ramp = paint(400, 96, (x) => {
    const value = Math.round((255 * Math.min(Math.max(x - 100, 0), 200)) / 200);
    return [value, value, value, 255];
  });
  const params = { ...INK, angle: 0, bow: 1, crossing: 0, spacing: 32, pressure: 0.5 };
  const image = await applyShader(page, 'filters/engraving.fs', { inputImage: ramp }, params);
  /** Middle of the line nearest to a height in a column, from the bottom. */
  const middle = (x: number, near: number) => {
    let [sum, weight] = [0, 0];
    for (let y = Math.round(near) - 16; y < near + 16; y++) {
      const ink = 1 - red(image, x, 95 - y);
      sum += ink * (y + 0.5);
      weight += ink;
    }
    return sum / weight;
  };
  // Brightness grows by 1 / 200 per pixel, so a line falls by 40 / 200.
  const first = middle(170, 60);
  const found = middle(230, first - 12);
  expect(Math.abs(found - (first - 12))).toBeLessThan(1.5);
});

/** Colors of three areas, as straight channels from 0 to 1. */
const COLORS = [
  [0.6, 0.45, 0.35],
  [0.3, 0.45, 0.6],
  [0.5, 0.5, 0.5],
] as const;
const colored = paint(
  360,
  120,
  (x) => [...(COLORS[Math.floor(x / 120)] ?? COLORS[0]).map((value) => Math.round(value * 255)), 255] as [number, number, number, number],
);

test('pointillism mixes dabs of several hues whose mean is the color of the image', async () => {
  const image = await applyShader(page, 'filters/pointillism.fs', { inputImage: colored }, { density: 1, hues: 0.8 });
  COLORS.forEach((color, i) => {
    const sums = [0, 0, 0];
    const hues = new Set<number>();
    let count = 0;
    for (let y = 10; y < 110; y++) {
      for (let x = i * 120 + 12; x < i * 120 + 108; x++) {
        const [r, g, b] = pixelAt(image, x, y);
        [r, g, b].forEach((value, c) => {
          sums[c] = (sums[c] ?? 0) + value / 255;
        });
        if (Math.max(r, g, b) - Math.min(r, g, b) > 25) hues.add(Math.round(Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b) * 5));
        count++;
      }
    }
    color.forEach((value, c) => {
      expect(Math.abs((sums[c] ?? 0) / count - value)).toBeLessThan(0.035);
    });
    if (i < 2) expect(hues.size).toBeGreaterThan(5);
  });
});

test('pointillism shows the canvas where no dab is, and nothing where the layer is transparent', async () => {
  const canvas = { density: 0, canvasColor: [0, 1, 0, 1] };
  expect(pixelAt(await applyShader(page, 'filters/pointillism.fs', { inputImage: colored }, canvas), 60, 60)).toEqual([0, 255, 0, 255]);
  expect(pixelAt(await draw('pointillism', {}), WIDTH - 20, 60)).toEqual([0, 0, 0, 0]);
  const [a, b] = [await draw('pointillism', {}, 1), await draw('pointillism', {}, 2)];
  expect(mean(2, (x, y) => Math.abs(red(a, x, y) - red(b, x, y)) * 255)).toBeLessThan(2);
});
