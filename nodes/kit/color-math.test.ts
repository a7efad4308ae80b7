import { describe, expect, test } from '@jest/globals';
import { Color } from 'three';
import {
  hslFromRgb,
  hsvFromRgb,
  linearFromOklab,
  linearFromSrgb,
  oklabFromLinear,
  rgbFromHsl,
  rgbFromHsv,
  srgbFromLinear,
} from './color-math.ts';

const COLORS: readonly (readonly [number, number, number])[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 0],
  [0.2, 0.4, 0.6],
  [0.9, 0.1, 0.5],
  [0.1, 0.7, 0.3],
  [0.5, 0.5, 0.5],
  [0, 0, 0],
  [1, 1, 1],
];

function made(write: (out: number[]) => void): number[] {
  const out = [0, 0, 0];
  write(out);
  return out;
}

function expectClose(actual: readonly number[], expected: readonly number[], digits = 9): void {
  actual.forEach((x, i) => {
    expect(x).toBeCloseTo(expected[i] ?? Number.NaN, digits);
  });
}

describe.each(COLORS)('color %d %d %d', (r, g, b) => {
  test('has the hue, saturation and lightness that three.js finds, and comes back from them', () => {
    const [h = 0, s = 0, l = 0] = made((out) => hslFromRgb(out, r, g, b));
    const theirs = new Color(r, g, b).getHSL({ h: 0, s: 0, l: 0 }, 'srgb-linear');
    expectClose([h, s, l], [theirs.h, theirs.s, theirs.l]);
    expectClose(
      made((out) => rgbFromHsl(out, h + 3, s, l)),
      [r, g, b],
    );
  });

  test('comes back from HSV, whose value is its largest channel', () => {
    const [h = 0, s = 0, v = 0] = made((out) => hsvFromRgb(out, r, g, b));
    expect(v).toBe(Math.max(r, g, b));
    expectClose(
      made((out) => rgbFromHsv(out, h - 2, s, v)),
      [r, g, b],
    );
  });

  test('comes back from linear light and from Oklab', () => {
    expect(linearFromSrgb(r)).toBeCloseTo(new Color().setRGB(r, g, b, 'srgb').r, 6);
    expect(srgbFromLinear(linearFromSrgb(g))).toBeCloseTo(g, 9);
    const [l = 0, a = 0, c = 0] = made((out) => oklabFromLinear(out, r, g, b));
    expectClose(
      made((out) => linearFromOklab(out, l, a, c)),
      [r, g, b],
      5,
    );
  });
});

test('Oklab is that of its author', () => {
  // From the table in his article: XYZ (0.950, 1, 1.089) is white, L 1; sRGB red is 0.628, 0.225, 0.126.
  expectClose(
    made((out) => oklabFromLinear(out, 1, 1, 1)),
    [1, 0, 0],
    3,
  );
  expectClose(
    made((out) => oklabFromLinear(out, 1, 0, 0)),
    [0.628, 0.225, 0.126],
    3,
  );
});
