import { describe, expect, test } from '@jest/globals';
import { flickerBetween, type Shot } from './flicker.ts';
import { meanOf } from './mean-of.ts';
import { countOcclusion, occlusionIou } from './occlusion.ts';
import { contrastOf, type ImagePixels, smoothed } from './smooth.ts';
import { toneError } from './tone.ts';

const [WIDTH, HEIGHT] = [16, 12];

function gray(at: (x: number, y: number) => number, widthPx = WIDTH, heightPx = HEIGHT): ImagePixels {
  const pixels = Array.from({ length: widthPx * heightPx }, (_, i) => {
    const value = at(i % widthPx, Math.floor(i / widthPx));
    return [value, value, value, 255];
  });
  return { widthPx, heightPx, pixels: pixels.flat() };
}

/** A camera at x meters that looks along -z at a wall 2 m away. 16 px of focal length: 1 px is 0.125 m there. */
function shot(xM: number, depthM: (x: number) => number = () => 2): Shot {
  return {
    widthPx: WIDTH,
    heightPx: HEIGHT,
    camera: { fxPx: 16, fyPx: 16, cxPx: 8, cyPx: 6 },
    worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, xM, 0, 0, 1],
    depthM: Array.from({ length: WIDTH * HEIGHT }, (_, i) => depthM(i % WIDTH)),
  };
}

describe('occlusion', () => {
  const layer = (shown: readonly boolean[], layerM = [1, 1, 3, 3]) => ({
    layerM,
    whole: layerM.flatMap(() => [0, 0, 0, 255]),
    shown: shown.flatMap((is) => [0, 0, 0, is ? 255 : 0]),
  });
  const ROOM = [2, 2, 2, 2];
  const iou = (shown: readonly boolean[], layerM?: number[]) => occlusionIou([countOcclusion(layer(shown, layerM), ROOM)]);

  test.each([
    ['what is right', [true, true, false, false], 1, 1],
    ['nothing hidden', [true, true, true, true], 2 / 4, 0],
    ['all hidden', [false, false, false, false], 0, 2 / 4],
    ['one pixel too many', [true, true, true, false], 2 / 3, 1 / 2],
  ])('%s', (_name, shown, visible, hidden) => {
    expect(iou(shown)).toEqual({ visible, hidden, hiddenShare: 0.5 });
  });

  test('pixels without depth, or hardly covered, do not count; there is no error where nothing is', () => {
    expect(iou([true, true, true, true], [1, 1, 0, 0])).toMatchObject({ visible: 1, hidden: 1 });
    const faint = { ...layer([true, true, true, true]), whole: [255, 255, 100, 100].flatMap((alpha) => [0, 0, 0, alpha]) };
    expect(occlusionIou([countOcclusion(faint, ROOM)])).toMatchObject({ visible: 1, hidden: 1 });
  });

  test('a translucent pixel is drawn if more than half of it is left', () => {
    const translucent = { layerM: [1, 3], whole: [0, 0, 0, 140, 0, 0, 0, 140], shown: [0, 0, 0, 80, 0, 0, 0, 60] };
    expect(occlusionIou([countOcclusion(translucent, ROOM)])).toMatchObject({ visible: 1, hidden: 1 });
  });
});

describe('flicker', () => {
  const texture = (x: number, y: number) => (x * x * 7 + y * 31) % 256;

  test('what moves with the surface has none; what stays on the screen has the difference of its pixels', () => {
    // The camera moves by 2 px to the right, so the wall moves to the left.
    const [before, now] = [shot(0), shot(0.25)];
    const moved = flickerBetween(
      before,
      gray(texture),
      now,
      gray((x, y) => texture(x + 2, y)),
    );
    // The last two columns come from outside of the previous frame.
    expect(moved).toEqual({ sum: 0, count: (WIDTH - 2) * HEIGHT });
    const ramp = gray((x) => 10 * x);
    expect(meanOf([flickerBetween(before, ramp, now, ramp)])).toBeCloseTo(20);
  });

  test('between pixels, the previous frame is interpolated', () => {
    const ramp = (shift: number) => gray((x) => 10 * (x + shift));
    expect(meanOf([flickerBetween(shot(0), ramp(0), shot(0.0625), ramp(0.5))])).toBeCloseTo(0);
  });

  test('what was hidden in the previous frame does not count', () => {
    // A pillar 1 m away, which moves twice as far as the wall.
    const before = shot(0, (x) => (x === 8 ? 1 : 2));
    const now = shot(0.125, (x) => (x === 6 ? 1 : 2));
    const white = flickerBetween(
      before,
      gray(() => 0),
      now,
      gray((x) => (x === 7 ? 255 : 0)),
    );
    expect(white.sum).toBe(0);
    expect(white.count).toBeGreaterThan(0.6 * WIDTH * HEIGHT);
  });

  test('is that of a turn, too', () => {
    const turn = Math.atan(1 / 16);
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const ramp = gray((x) => 10 * x);
    const only = shot(0).depthM;
    const turned = {
      ...shot(0),
      worldFromCamera: [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1],
      // Only the pixel half a pixel to the right of the axis.
      depthM: Array.from(only, (m, i) => (i === 6 * WIDTH + 8 ? m : 0)),
    };
    const straight = { ...shot(0), depthM: Array.from(only, () => 2 * (c - (0.5 / 16) * s)) };
    const { sum, count } = flickerBetween(straight, ramp, turned, ramp);
    expect(count).toBe(1);
    expect(sum).toBeCloseTo(10 * (16 * Math.tan(Math.atan(0.5 / 16) + turn) - 0.5), 3);
  });
});

test('smoothing is the mean of a square, with the border repeated', () => {
  expect([...smoothed([0, 0, 9, 0, 0], 5, 1, 1)]).toEqual([0, 3, 3, 3, 0]);
  expect([...smoothed([9, 0, 0], 3, 1, 1)]).toEqual([6, 3, 0]);
  expect(smoothed([0, 0, 0, 0, 9, 0, 0, 0, 0], 3, 3, 1)[4]).toBeCloseTo(1);
});

test('contrast is the difference from the tone around, and a blur has less', () => {
  const stripes = gray((x) => (x % 2 === 0 ? 0 : 90));
  // The mean of three is 60 around 0 and 30 around 90. At both ends the border is repeated, so the pixel differs by 30.
  expect(contrastOf(stripes, 1)).toBeCloseTo((14 * 60 + 2 * 30) / 16, 3);
  expect(
    contrastOf(
      gray(() => 128),
      3,
    ),
  ).toBeCloseTo(0);
});

describe('tone error', () => {
  const all = new Uint8Array(WIDTH * HEIGHT).fill(1);

  test('strokes count by their mean', () => {
    const checks = gray((x, y) => ((x + y) % 2 === 0 ? 0 : 200));
    const { sum, count } = toneError(
      checks,
      gray(() => 100),
      all,
      5,
    );
    expect(sum / count).toBeLessThan(10);
    expect(
      meanOf([
        toneError(
          gray(() => 130),
          gray(() => 100),
          all,
          5,
        ),
      ]),
    ).toBeCloseTo(30, 3);
  });

  test('what is left out does not bleed', () => {
    const half = all.map((_, i) => (i % WIDTH < 8 ? 1 : 0));
    const { sum, count } = toneError(
      gray((x) => (x < 8 ? 50 : 255)),
      gray(() => 50),
      half,
      4,
    );
    expect(sum).toBeCloseTo(0, 3);
    expect(count).toBe(8 * HEIGHT);
  });
});
