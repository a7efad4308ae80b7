import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/room-depth.page.ts');

describe('room depth is cleaned before anything reads it', () => {
  test('holes of any size get the distance of what is around them, and what is known stays as it is', async () => {
    const found = await page.call<Record<string, unknown>>('holes');
    expect(found).toMatchObject({ changed: 0, wrong: 0, punched: 0, unknownIsEmpty: true, error: 0 });
    expect(found.off).toBe(found.holes);
    expect(found.holes).toBeGreaterThan(60);
  });

  test('a window is as far as the farthest surface around it, and stays unknown where the image cuts it off', async () => {
    const at = (m: number, digits = 1) => ({ middle: m === 0 ? 0 : expect.closeTo(m, digits), error: 0 });
    expect(await page.call('windows')).toEqual({ balcony: at(3, 3), sky: at(0), wall: at(1 / 0.65, 2), flying: at(3, 3) });
  });

  test('the confidence is low at borders, in noise and where a hole was filled, and full on slopes', async () => {
    const found = await page.call<{ size: number[]; row: number[]; open: number; calm: number; noisy: number; plain: number }>(
      'confidences',
    );
    const [floor, , near, edge, far, beyond, wall, hole, right] = found.row;
    expect(found.size).toEqual([32, 18]);
    expect([floor, wall, right, found.plain]).toEqual([255, 255, 255, 255]);
    // One sample from the border: 1/4 + 3/4 smoothstep(0.5, 3, 1).
    expect([edge, far]).toEqual([84, 84]);
    for (const value of [near, beyond]) {
      expect(value).toBeGreaterThan(100);
      expect(value).toBeLessThan(255);
    }
    expect([hole, found.open]).toEqual([64, 0]);
    // Noise of half the typical error does not matter; twice that error does.
    expect(found.calm).toBeGreaterThan(245);
    expect(found.noisy).toBeLessThan(170);
  });

  test('smoothing takes noise away, and what moves leaves no trail', async () => {
    const raw = await page.call<{ spreadM: number }>('moving', 0);
    const calm = await page.call<{ trail: number; missing: number; spreadM: number; error: number }>('moving', 0.3);
    expect(calm).toMatchObject({ trail: 0, missing: 0, error: 0 });
    expect(raw.spreadM).toBeGreaterThan(0.0085);
    // The mean of an endless exponential window: σ √((1 - k) / (1 + k)), k = exp(-1/9), which is 0.236 σ. Some have just restarted.
    expect(calm.spreadM).toBeLessThan(0.236 * 0.01 * 1.4);
  });

  test('smoothing follows the eye as it moves, whichever way the sensor is turned', async () => {
    const { mean, spreadM, error } = await page.call<{ mean: number; spreadM: number; error: number }>('walking', 0.3);
    expect(error).toBe(0);
    expect(Math.abs(mean)).toBeLessThan(0.002);
    expect(spreadM).toBeLessThan(0.0065);
  });

  test('edge-aware: the border is sharp, and stands where the camera sees the edge', async () => {
    expect(await page.call('edges', true)).toEqual({
      size: [128, 72],
      border: expect.closeTo(0.45 * 128, -0.31),
      between: 0,
      ends: [expect.closeTo(1, 2), expect.closeTo(3, 2)],
      error: 0,
    });
    // Between the samples at 13.5 and 14.5 of 32, where without a camera nothing says more.
    expect(await page.call('edges', false)).toMatchObject({ border: 56, between: 0, error: 0 });
  });

  test('by sensor: coarse depth is interpolated to the pixels of the view, and fine depth is left at its own', async () => {
    const sizes = [
      [128, 72],
      [321, 2],
    ];
    expect(await page.call('bySensor', [320, 321])).toEqual({ sizes, error: 0 });
  });

  test('a picture is depth by its shades, laid over the view', async () => {
    const half = (4 * (255 - 128) + 128) / 255;
    const byDistance = await page.call('painted', 'distance', false);
    expect(byDistance).toEqual({
      meters: [4, 4, expect.closeTo(half, 2), 1, 0, 1],
      // A view of 16 to 9 cut from the middle of a picture of 6 to 1.
      uv: [0.296, 0, 0, 0, 1, 0, 0.352, 0, 1],
      error: 0,
    });
    // What is not painted stays unknown also where holes of sensors are filled, as they are by default.
    expect(await page.call('painted', 'distance', true)).toEqual(byDistance);
    const inverse = 1 / (0.25 * (1 - 128 / 255) + 128 / 255);
    expect(await page.call('painted', 'inverse', false)).toMatchObject({ meters: [4, 4, expect.closeTo(inverse, 2), 1, 0, 1] });
  });

  test('creates no GPU objects per frame, and leaks none', async () => {
    expect(await page.call('leftBehind')).toEqual({ flat: true, left: [], error: 0 });
  });

  test('is handed on as it was measured where the GPU can draw no floats', async () => {
    expect(await page.call('withoutFloats')).toEqual({ first: [1, 2, 3], interpolate: true });
  });
});

test('the depth view is red near, green midway, blue far and gray where nothing is known, with a scale that can be turned off', async () => {
  const { colors, ink, bar, error } = await page.call<{ colors: number[][]; ink: number[]; bar: number[][]; error: number }>('depthView');
  expect(colors.slice(0, 3)).toEqual([
    [255, 0, 0, 255],
    [0, 255, 0, 255],
    [0, 0, 255, 255],
  ]);
  const [r = 0, g, b] = colors[3] ?? [];
  expect([g, b]).toEqual([r, r]);
  expect(r).toBeLessThan(64);
  // Six numbers of a few dozen dots, each dot about two pixels.
  expect(ink[0]).toBe(0);
  expect(ink[1]).toBeGreaterThan(100);
  expect(bar[0]?.[0]).toBeGreaterThan(240);
  expect(bar[1]?.[2]).toBeGreaterThan(240);
  expect(error).toBe(0);
});

test('depth of a camera that stands and looks elsewhere is brought to where the view sees it, and what it does not see stays unknown', async () => {
  const found = await page.call<Record<'right' | 'wrong' | 'unknown' | 'between' | 'all' | 'error', number>>('reprojected');
  expect(found.error).toBe(0);
  const known = found.all - found.unknown;
  // The depth camera sees a good half of the view.
  expect(known / found.all).toBeGreaterThan(0.4);
  expect(known / found.all).toBeLessThan(0.75);
  expect(found.right / known).toBeGreaterThan(0.97);
  expect(found.between).toBe(0);
});

test('depth measured through the lens of the view is taken as it is, whatever its near and far planes', async () => {
  expect(await page.call('lenses')).toEqual({ same: 0, otherPlanes: 0, wider: 1, shifted: 1 });
});
