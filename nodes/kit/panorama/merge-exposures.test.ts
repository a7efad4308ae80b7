import { describe, expect, test } from '@jest/globals';
import { DataUtils } from 'three';
import { srgbFromLinear } from '../color-math.ts';
import { halfBits, halvesWithAlpha } from './half-floats.ts';
import { mergeExposures } from './merge-exposures.ts';
import { type PanoramaPixels, runWhole } from './pixels.ts';

const W = 64;
const H = 32;

/** Walls that get brighter towards a window, with a lamp of 4 × 4 pixels that is 300 times as bright as white. */
const ROOM = Float32Array.from({ length: W * H * 3 }, (_, i) => {
  const [x, y, c] = [Math.floor(i / 3) % W, Math.floor(i / 3 / W), i % 3];
  if (x >= 40 && x < 44 && y >= 8 && y < 12) return [300, 240, 150][c] ?? 0;
  return (0.03 + 30 * (x / W) ** 6 + 0.2 * (y / H)) * ([1, 0.8, 0.6][c] ?? 0);
});

/** A photo of the room, as a camera with the curve of sRGB takes it. */
function shot(stops: number, channels: 3 | 4 = 3): PanoramaPixels {
  const data = new Uint8Array(W * H * channels).fill(255);
  for (let i = 0; i < ROOM.length; i++) {
    const at = Math.floor(i / 3) * channels + (i % 3);
    data[at] = Math.round(255 * srgbFromLinear(Math.min(1, (ROOM[i] ?? 0) * 2 ** stops)));
  }
  return { widthPx: W, heightPx: H, channels, data };
}

const merge = (shots: readonly PanoramaPixels[], stopsApart = 0) => runWhole(mergeExposures(shots, stopsApart));

describe('shots of different exposure', () => {
  test.each([
    ['the brightest first', [0, -3, -6, -9]],
    ['in any order', [-6, 0, -9, -3]],
    ['of uneven exposures', [0, -4.5, -9]],
  ])('become the radiance that the camera saw: %s', (_how, exposures) => {
    const { data, stops, whitePart } = merge(exposures.map((stop, i) => shot(stop, i === 1 ? 4 : 3)));
    const [first = 0] = exposures;
    for (const [i, stop] of exposures.entries()) expect(stops[i]).toBeCloseTo(stop - first, 1);
    expect(whitePart).toBe(0);
    const errors = [...data].map((value, i) => Math.abs(value / ((ROOM[i] ?? 0) * 2 ** first) - 1)).sort((a, b) => a - b);
    // Steps of 8 bits are up to 4 % of a dark value.
    expect(errors[Math.floor(errors.length * 0.99)]).toBeLessThan(0.04);
    const lamp = (10 * W + 41) * 3;
    for (let c = 0; c < 3; c++) expect((data[lamp + c] ?? 0) / ((ROOM[lamp + c] ?? 0) * 2 ** first)).toBeCloseTo(1, 1);
  });

  test('keep what is white in all of them as white of the darkest, and say how much', () => {
    const { data, whitePart } = merge([shot(0), shot(-5.5)]);
    expect((data[(10 * W + 41) * 3] ?? 0) / 2 ** 5.5).toBeCloseTo(1, 1);
    // 16 pixels, three rows to the side of the equator.
    expect(whitePart).toBeCloseTo((16 / (W * H)) * Math.sin((10 / H) * Math.PI) * (Math.PI / 2), 3);
  });

  test('are apart as set, where that is set', () => {
    expect(merge([shot(0), shot(-3)], 4).stops).toEqual([0, -4]);
  });

  test.each([
    ['one alone', [shot(0)], /two exposures or more/],
    [
      'of other sizes',
      [shot(0), { widthPx: 2, heightPx: 1, channels: 3, data: new Uint8Array(6) } as const],
      /shot 2 has 2 × 1 pixels, and the first has 64 × 32/,
    ],
    ['with radiance', [shot(0), { ...shot(0), data: new Float32Array(W * H * 3) }], /shot 2 contains the full range/],
    ['too far apart', [shot(6), shot(-9)], /shots 1 and 2 show nothing in common.*Add a shot between them/],
    ['that are black', [shot(0), shot(-30)], /nothing in common/],
  ])('are refused with a remedy: %s', (_what, shots, reason) => {
    expect(() => merge(shots as readonly PanoramaPixels[])).toThrow(reason);
  });
});

test('half floats are those of three.js, to the last bit but one', () => {
  for (const value of [0, 1e-9, 3e-6, 6.1e-5, 0.001, 0.2, 1, 1.0004, 250, 65503, 65504]) {
    expect(Math.abs(halfBits(value) - DataUtils.toHalfFloat(value))).toBeLessThanOrEqual(1);
  }
  expect([halfBits(1e9), halfBits(Number.NaN), halfBits(-1)]).toEqual([0x7bff, 0, 0]);
  expect([...halvesWithAlpha(Float32Array.of(1, 2, 0))]).toEqual([0x3c00, 0x4000, 0, 0x3c00]);
});
