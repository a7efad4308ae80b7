import { describe, expect, test } from '@jest/globals';
import { fillLamps } from './fill-lamps.ts';
import { directionAt } from './found-lamps.ts';
import { medianOf } from './median.ts';
import { momentsOf, outerContours } from './outer-contours.ts';
import { findByPaper } from './paper-method.ts';
import { type PanoramaPixels, runWhole } from './pixels.ts';
import { findBySolidAngle } from './solid-angle-method.ts';

/** An image of characters: `#` is 1. */
function image(...rows: string[]): { pixels: Uint8Array; widthPx: number; heightPx: number } {
  return { pixels: Uint8Array.from(rows.join(''), (one) => (one === '#' ? 1 : 0)), widthPx: rows[0]?.length ?? 0, heightPx: rows.length };
}

function contoursOf(...rows: string[]) {
  const { pixels, widthPx, heightPx } = image(...rows);
  return outerContours(pixels, widthPx, heightPx);
}

describe('contours', () => {
  test('of a square go around its border pixels, also at the edge of the image', () => {
    const [contour, ...others] = contoursOf('###.', '###.', '###.', '....');
    expect(others).toEqual([]);
    expect(contour).toHaveLength(16);
    expect(contour && momentsOf(contour)).toEqual({ areaPx: 4, centerPx: [1, 1] });
  });

  test('of regions in holes of others are left out, and of regions beside them are not', () => {
    expect(contoursOf('#####..', '#...#.#', '#.#.#..', '#...#..', '#####..')).toHaveLength(2);
  });

  test('regions that touch at a corner are one; lines and single pixels have no area', () => {
    expect(contoursOf('#..', '.#.', '..#')).toHaveLength(1);
    expect(contoursOf('####').map(momentsOf)).toEqual([null]);
    expect(contoursOf('...', '.#.').map(momentsOf)).toEqual([null]);
  });
});

test('the median keeps what fills more than half of 25 pixels', () => {
  const { pixels, widthPx, heightPx } = image('.......', '.####..', '.####..', '.####..', '.####..', '......#', '.......');
  const ones = [...medianOf(pixels, widthPx, heightPx)].flatMap((one, i) => (one ? [[i % widthPx, Math.floor(i / widthPx)]] : []));
  // The corners of the square see 9 of its pixels and lose theirs; the pixel alone is gone, and helps one beside it.
  expect(ones).toEqual([
    [2, 2],
    [3, 2],
    [2, 3],
    [3, 3],
    [4, 3],
  ]);
});

describe('the paper’s method', () => {
  const W = 96;
  const H = 48;
  /** Bytes: gray walls, and squares of other brightness. */
  function bytes(wall: number, ...squares: readonly (readonly [x: number, y: number, side: number, level: number])[]): PanoramaPixels {
    const data = new Uint8Array(W * H * 3).fill(wall);
    for (const [left, top, side, level] of squares) {
      for (let y = top; y < top + side; y++) data.fill(level, (y * W + left) * 3, (y * W + left + side) * 3);
    }
    return { widthPx: W, heightPx: H, channels: 3, data };
  }
  const search = (pixels: PanoramaPixels, iterations = 1, intensities: 'ranks' | 'area' = 'ranks') =>
    runWhole(findByPaper(pixels, { lamps: 3, iterations, intensities }));

  test('finds a dim window only in its second iteration', () => {
    const pixels = bytes(40, [10, 10, 7, 250], [60, 20, 8, 160]);
    expect(search(pixels).lamps.map(({ iteration }) => iteration)).toEqual([0]);
    const { lamps } = search(pixels, 2);
    // The larger area is first, and gets all of the intensity.
    expect(lamps.map(({ areaPx, iteration }) => [areaPx, iteration])).toEqual(
      [
        [49 - 4, 1],
        [36 - 4, 0],
      ].map(([, iteration], i) => [lamps[i]?.areaPx, iteration]),
    );
    expect(lamps.map(({ irradiance }) => irradiance[0] / Math.PI)).toEqual([1, 0.7]);
    expect(search(pixels, 2, 'area').lamps[1]?.irradiance[0]).toBeCloseTo((Math.PI * (lamps[1]?.areaPx ?? 0)) / (lamps[0]?.areaPx ?? 1), 9);
  });

  test.each([
    ['white', bytes(255), 'bright-all-over'],
    ['black, whose ratio is 0 / 0,', bytes(0), 'black'],
    ['half bright', bytes(20, [0, 0, 40, 255]), 'too-much-above'],
    ['with lamps smaller than the median', bytes(20, [10, 10, 2, 255]), 'lost-in-median'],
    ['of one pixel', { widthPx: 1, heightPx: 1, channels: 3, data: Uint8Array.of(9, 9, 9) } as const, 'bright-all-over'],
  ] as const)('a panorama that is %s is refused with its reason', (_what, pixels, none) => {
    const found = search(pixels, 3);
    expect([found.lamps, found.none, found.runs]).toEqual([[], none, []]);
  });
});

describe('the method by solid angle', () => {
  const W = 128;
  const H = 64;
  function sky(...lamps: readonly (readonly [thetaDeg: number, phiDeg: number, radiusDeg: number, radiance: number])[]): PanoramaPixels {
    const data = new Float32Array(W * H * 3).fill(0.1);
    const centers = lamps.map(([thetaDeg, phiDeg]) => directionAt(((thetaDeg + 180) / 360) * W, ((90 - phiDeg) / 180) * H, W, H));
    for (let i = 0; i < W * H; i++) {
      const [x, y, z] = directionAt((i % W) + 0.5, Math.floor(i / W) + 0.5, W, H);
      for (const [k, center] of centers.entries()) {
        const [, , radiusDeg = 0, radiance = 0] = lamps[k] ?? [];
        if (x * center[0] + y * center[1] + z * center[2] < Math.cos((radiusDeg * Math.PI) / 180)) continue;
        data.fill(radiance, i * 3, i * 3 + 3);
      }
    }
    return { widthPx: W, heightPx: H, channels: 3, data };
  }
  const search = (pixels: PanoramaPixels, lamps = 3) => runWhole(findBySolidAngle(pixels, { lamps, clippedShare: 0.5 }));

  test('measures a round lamp the same at the zenith as at the horizon: π sin² r of its radiance', () => {
    const expected = Math.PI * Math.sin((8 * Math.PI) / 180) ** 2 * (50 - 0.1);
    for (const phiDeg of [2, 50, 86]) {
      const [lamp] = search(sky([70, phiDeg, 8, 50])).lamps;
      expect((lamp?.irradiance[0] ?? 0) / expected).toBeCloseTo(1, 1);
      expect(((lamp?.sizeRad ?? 0) * 180) / Math.PI / 16).toBeCloseTo(1, 1);
      expect((Math.asin(lamp?.towards[1] ?? 0) * 180) / Math.PI).toBeCloseTo(phiDeg, 0);
    }
  });

  test('200 equal lamps give at most as many lights as wanted', () => {
    const many = Array.from({ length: 200 }, (_, i) => [((i * 137.5) % 360) - 180, 80 - i * 0.75, 2, 100] as const);
    const found = search(sky(...many), 3);
    expect(found.lamps.length).toBeLessThanOrEqual(3);
    for (const { irradiance } of found.lamps) expect(irradiance.every(Number.isFinite)).toBe(true);
    // Neighbors are joined as far as one light can stand for them; the others stay in the rest.
    expect(found.more).toBeGreaterThan(5);
    expect(search(sky([-120, 30, 5, 90], [60, 20, 5, 60]), 2).more).toBeUndefined();
  });

  test('tells lamps on opposite sides apart, and leaves the third to the rest', () => {
    const azimuths = search(sky([-120, 30, 5, 90], [60, 20, 5, 60], [0, 10, 5, 20]), 2).lamps.map(
      ({ towards }) => Math.round((Math.atan2(towards[0], -towards[2]) * 18) / Math.PI) * 10,
    );
    expect(azimuths).toEqual([-120, 60]);
  });

  test('works on whole rows of a panorama of 8192 pixels without taking a slice of more than 32 rows', () => {
    const slices = findBySolidAngle(
      { widthPx: 8192, heightPx: 64, channels: 1, data: new Uint16Array(8192 * 64) },
      { lamps: 1, clippedShare: 0 },
    );
    let count = 0;
    while (!slices.next().done) count++;
    expect(count).toBeGreaterThan(2);
  });
});

test('lamps are filled from what is around them, also across the seam', () => {
  const [widthPx, heightPx] = [8, 4];
  const levels = new Float32Array(widthPx * heightPx).fill(2);
  const runs = [1, 0, 2, 1, 7, 8, 2, 7, 8];
  for (let k = 0; k < runs.length; k += 3)
    levels.fill(100, (runs[k] ?? 0) * widthPx + (runs[k + 1] ?? 0), (runs[k] ?? 0) * widthPx + (runs[k + 2] ?? 0));
  const target = {
    widthPx,
    heightPx,
    get: (x: number, y: number) => levels[y * widthPx + x] ?? 0,
    set: (x: number, y: number, _channel: number, value: number) => void levels.fill(value, y * widthPx + x, y * widthPx + x + 1),
  };
  fillLamps(target, runs, { widthPx, heightPx });
  expect([...new Set(levels)]).toEqual([2]);
});

test('a larger image is filled as its pixels one by one, by 1 / distance to the next pixels outside lamps', () => {
  // Cells of 3 × 3 pixels; the last column has a single pixel.
  const [widthPx, heightPx, step] = [22, 12, 3];
  const size = { widthPx: 8, heightPx: 4 };
  const runs = [0, 2, 4, 1, 0, 3, 1, 6, 8, 2, 0, 1, 2, 7, 8, 3, 4, 5];
  const isLamp = (x: number, y: number): boolean => {
    const [column, row] = [Math.floor(x / step), Math.floor(y / step)];
    return runs.some((first, k) => k % 3 === 0 && first === row && column >= (runs[k + 1] ?? 0) && column < (runs[k + 2] ?? 0));
  };
  const levels = Float64Array.from({ length: widthPx * heightPx }, (_, i) => (i * 37) % 101);
  const expected = levels.map((level, i) => {
    const [x, y] = [i % widthPx, Math.floor(i / widthPx)];
    if (!isLamp(x, y)) return level;
    let [sum, weights] = [0, 0];
    for (const [dx, dy] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ] as const) {
      for (let far = 1; far < widthPx; far++) {
        const [at, row] = [(x + dx * far + widthPx * far) % widthPx, y + dy * far];
        if (row < 0 || row >= heightPx) break;
        if (isLamp(at, row)) continue;
        sum += (levels[row * widthPx + at] ?? 0) / far;
        weights += 1 / far;
        break;
      }
    }
    return sum / weights;
  });
  const target = {
    widthPx,
    heightPx,
    get: (x: number, y: number) => levels[y * widthPx + x] ?? 0,
    set: (x: number, y: number, _channel: number, value: number) => void levels.fill(value, y * widthPx + x, y * widthPx + x + 1),
  };
  fillLamps(target, runs, size);
  for (const [i, level] of levels.entries()) expect(level).toBeCloseTo(expected[i] ?? 0, 9);
});
