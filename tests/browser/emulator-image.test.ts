import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import type { Landmark, MovedLight } from './emulator-image.page.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/emulator-image.page.ts');
});
afterAll(async () => {
  await page?.close();
});

describe('camera image, picture and depth agree', () => {
  test.each([
    ['one view', { device: 'phone' }, 1],
    ['two views', { device: 'headset' }, 2],
    [
      'two views, a turned sensor',
      { device: 'headset', depth: { usages: ['cpu-optimized'], formats: ['float32'], transform: { turnDeg: 90 } } },
      2,
    ],
  ])('on three landmarks, %s', async (_, options, views) => {
    const found = await page.call<Landmark[]>('landmarks', options);
    expect(found).toHaveLength(3 * views);
    found.forEach(({ cameraChannel, imageChannel, depthErrorM }, i) => {
      // Red, green, blue in this order.
      expect([cameraChannel, imageChannel]).toEqual([i % 3, i % 3]);
      // The cube's front is up to half its diagonal nearer than its center.
      expect(depthErrorM).toBeLessThan(-0.03);
      expect(depthErrorM).toBeGreaterThan(-0.11);
    });
  });

  test('the camera image is the room that the user sees, byte for byte', async () => {
    expect(await page.call('cameraAgainstRoom')).toBe(0);
  });
});

type Blended = Record<'layer' | 'room' | 'composite' | 'beside' | 'shown' | 'bareRoom', number[]>;

describe('what the user sees', () => {
  test('a premultiplied layer over the room', async () => {
    const { layer, room, composite, beside, shown, bareRoom } = await page.call<Blended>('blending', { device: 'phone' });
    expect(layer).toEqual([128, 0, 0, 128]);
    expect(beside).toEqual(bareRoom);
    const expected = [0, 1, 2].map((c) => (layer[c] ?? 0) + Math.round(((room[c] ?? 0) * 127) / 255));
    expect(composite).toEqual([...expected, 255]);
    // The canvas on screen is blended by the GPU, which may round the other way.
    shown.forEach((value, c) => {
      expect(Math.abs(value - (composite[c] ?? 0))).toBeLessThanOrEqual(1);
    });
  });

  test('the same when nothing is put on the screen', async () => {
    const shown = await page.call<Blended>('blending', { device: 'phone' });
    const unshown = await page.call<Blended>('blending', { device: 'phone', display: false });
    expect(unshown).toEqual({ ...shown, shown: [] });
  });

  test('on glasses, light added to the room', async () => {
    const { layer, room, composite } = await page.call<Blended>('blending', { device: 'glasses' });
    expect(room[0]).toBeGreaterThan(0);
    // The display is twice as bright as the room, and light adds in linear values (sRGB, IEC 61966-2-1).
    const linear = (byte = 0) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
    const seen = (c: number) => 255 * (1.055 * Math.min(1, linear(room[c]) + 2 * linear(layer[c])) ** (1 / 2.4) - 0.055);
    expect(composite).toEqual([...[0, 1, 2].map((c) => expect.closeTo(seen(c), 0)), 255]);
  });

  test('nothing of what a page draws into its canvas', async () => {
    expect(await page.call('drawnIntoTheCanvas')).toEqual([0, 0, 0, 0]);
  });
});

test('a frame begins transparent, and the page’s GL state is left alone', async () => {
  const { before, after, begun, error } = await page.call<Record<'before' | 'after', unknown[]> & { begun: number[]; error: number }>(
    'stateOfThePage',
  );
  expect(begun).toEqual([0, 0, 0, 0]);
  expect(after).toEqual(before);
  expect(before).toContain(true);
  expect(error).toBe(0);
});

test('light is estimated from the room', async () => {
  const found = await page.call<{
    changes: number;
    harmonics: number[];
    direction: number[];
    intensity: number[];
    channels: boolean[][];
    error: number;
  }>('light');
  expect(found.changes).toBe(1);
  expect(found.harmonics).toHaveLength(27);
  expect(found.error).toBe(0);
  const [x = 0, y = 0, z = 0, w] = found.direction;
  expect(Math.hypot(x, y, z)).toBeCloseTo(1, 5);
  expect(w).toBe(0);
  expect(found.intensity[3]).toBe(1);
  // Coefficients 1, 2 and 3 grow with y, z and x. Red comes from +x and −y, −z; green from −x, −y, +z; blue from +y and ±z.
  const [redY, greenY, blueY] = found.harmonics.slice(3, 6);
  expect(Math.sign(redY ?? 0)).toBe(-1);
  expect(Math.sign(greenY ?? 0)).toBe(-1);
  expect(Math.sign(blueY ?? 0)).toBe(1);
  const [redX = 0, greenX = 0] = found.harmonics.slice(9, 11);
  expect(redX).toBeGreaterThan(0.1);
  expect(greenX).toBeLessThan(-0.1);
  // Each wall of the cube map in its own color, at four corners: red, green, blue, yellow, cyan, magenta.
  const walls = [
    [true, false, false],
    [false, true, false],
    [false, false, true],
    [true, true, false],
    [false, true, true],
    [true, false, true],
  ];
  expect(found.channels).toEqual(walls.flatMap((wall) => [wall, wall, wall, wall]));
});

test('the room’s light can be moved: the room is lit from there, and the estimate says so', async () => {
  const fromRight = [0.8, 0.6, 0];
  const fromLeft = [-0.8, 0.6, 0];
  const seen = await page.call<MovedLight[]>('movedLight', [null, fromRight, fromLeft, [0, 1, 0], null]);
  const [home, right, left, above, back] = seen;
  if (!home || !right || !left || !above || !back) throw new Error('Something was not seen.');
  // The table throws its shadow away from the light: on the floor to its left, then to its right, then below itself alone.
  const bright = (of: MovedLight, side: number) => of.beside[side] ?? Number.NaN;
  expect(bright(left, 0) - bright(right, 0)).toBeGreaterThan(30);
  expect(bright(above, 0) - bright(right, 0)).toBeGreaterThan(30);
  expect(bright(above, 1) - bright(left, 1)).toBeGreaterThan(30);
  for (const [of, wanted] of [
    [right, fromRight],
    [left, fromLeft],
  ] as const) {
    of.direction.forEach((value, axis) => {
      expect(value).toBeCloseTo(wanted[axis] ?? Number.NaN, 5);
    });
  }
  // What the light meets is bright: the walls opposite to it.
  expect(left.harmonicX).toBeGreaterThan(right.harmonicX + 0.1);
  expect(seen.map(({ changes }) => changes)).toEqual([1, 2, 3, 4, 5]);
  expect(back).toEqual({ ...home, changes: 5 });
});

test.each([
  ['one view of the studio', { device: 'phone', room: 'studio' }],
  ['two views of blocks', { device: 'headset' }],
])('the same script gives the same pixels and depth, %s', async (_, options) => {
  const once = await page.call<number[]>('walk', options);
  const again = await page.call<number[]>('walk', options);
  expect(new Set(once).size).toBe(once.length);
  expect(again).toEqual(once);
});

test('nothing was complained about', () => {
  expect(page.errors).toEqual([]);
});
