import { describe, expect, test } from '@jest/globals';
import { layoutOf, type PanoramaLayout, wrongShape } from './layouts.ts';
import { toEquirectangular } from './to-equirectangular.ts';

/** Lamps of known directions and colors, in a dark room. */
const LAMPS = [
  { towards: [0, 0, -1], color: [255, 0, 0] },
  { towards: [1, 0, 0], color: [0, 255, 0] },
  { towards: [-1, 0, 0], color: [0, 0, 255] },
  { towards: [0, 1, 0], color: [255, 255, 0] },
  { towards: [0, -1, 0], color: [0, 255, 255] },
  { towards: [0.3, 0.2, 0.93], color: [255, 0, 255] },
  { towards: [0.58, 0.58, -0.57], color: [255, 255, 255] },
] as const;

const LAMP_RAD = 0.12;

/** The color of a direction. */
function room([x, y, z]: readonly [number, number, number]): readonly number[] {
  const lamp = LAMPS.find(({ towards: [a, b, c] }) => Math.acos(Math.min(1, (x * a + y * b + z * c) / Math.hypot(a, b, c))) < LAMP_RAD);
  return lamp?.color ?? [20, 20, 20];
}

type Seen = (u: number, v: number) => readonly [number, number, number] | null;

/** Paints an image from the direction of each pixel; u and v are in [0, 1] from the upper left. */
function paint(widthPx: number, heightPx: number, seen: Seen) {
  const data = new Uint8Array(widthPx * heightPx * 3);
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) {
      const direction = seen((x + 0.5) / widthPx, (y + 0.5) / heightPx);
      if (direction) data.set(room(unit(direction)), (y * widthPx + x) * 3);
    }
  }
  return { widthPx, heightPx, channels: 3 as const, data };
}

function unit([x, y, z]: readonly [number, number, number]): readonly [number, number, number] {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}

/** The mirrored ray by its textbook formula: d − 2 (d · n) n with d = −z. */
const ball: Seen = (u, v) => {
  const [nx, ny] = [2 * u - 1, 1 - 2 * v];
  const square = nx * nx + ny * ny;
  if (square >= 1) return null;
  const nz = Math.sqrt(1 - square);
  return [2 * nz * nx, 2 * nz * ny, 2 * nz * nz - 1];
};

/** A camera that looks along `forward` with 90° of view. */
const face = (u: number, v: number, forward: readonly number[], right: readonly number[], up: readonly number[]) =>
  [0, 1, 2].map((i) => (forward[i] ?? 0) + (2 * u - 1) * (right[i] ?? 0) + (1 - 2 * v) * (up[i] ?? 0)) as [number, number, number];

const AHEAD = [
  [0, 0, -1],
  [1, 0, 0],
  [0, 1, 0],
] as const;
const RIGHT = [
  [1, 0, 0],
  [0, 0, 1],
  [0, 1, 0],
] as const;
const BEHIND = [
  [0, 0, 1],
  [-1, 0, 0],
  [0, 1, 0],
] as const;
const LEFT = [
  [-1, 0, 0],
  [0, 0, -1],
  [0, 1, 0],
] as const;
/** The camera tilts up or down from straight ahead. */
const UP = [
  [0, 1, 0],
  [1, 0, 0],
  [0, 0, 1],
] as const;
const DOWN = [
  [0, -1, 0],
  [1, 0, 0],
  [0, 0, -1],
] as const;
/** It tilts down, and on until it looks back. */
const OVER = [
  [0, 0, 1],
  [1, 0, 0],
  [0, -1, 0],
] as const;

type Face = readonly [readonly number[], readonly number[], readonly number[]];

function grid(columns: number, rows: number, faces: readonly (Face | null)[]): Seen {
  return (u, v) => {
    const [column, row] = [Math.floor(u * columns), Math.floor(v * rows)];
    const found = faces[row * columns + column];
    return found ? face(u * columns - column, v * rows - row, ...found) : null;
  };
}

const IMAGES: readonly [layout: PanoramaLayout, widthPx: number, heightPx: number, seen: Seen][] = [
  ['ball', 320, 320, ball],
  ['cross', 256, 192, grid(4, 3, [null, UP, null, null, LEFT, AHEAD, RIGHT, BEHIND, null, DOWN, null, null])],
  ['cross-upright', 192, 256, grid(3, 4, [null, UP, null, LEFT, AHEAD, RIGHT, null, DOWN, null, null, OVER, null])],
  ['strip', 384, 64, grid(6, 1, [RIGHT, LEFT, UP, DOWN, AHEAD, BEHIND])],
  ['strip-upright', 64, 384, grid(1, 6, [RIGHT, LEFT, UP, DOWN, AHEAD, BEHIND])],
];

describe.each(IMAGES)('%s', (layout, widthPx, heightPx, seen) => {
  const panorama = toEquirectangular(paint(widthPx, heightPx, seen), layout);

  test('is told by its shape', () => {
    expect(layoutOf(widthPx, heightPx)).toBe(layout);
  });

  test.each(LAMPS)('shows the lamp towards $towards where it is', ({ towards, color }) => {
    const [x, y, z] = unit(towards);
    const column = Math.floor((Math.atan2(x, -z) / (2 * Math.PI) + 0.5) * panorama.widthPx) % panorama.widthPx;
    const row = Math.min(Math.floor((0.5 - Math.asin(y) / Math.PI) * panorama.heightPx), panorama.heightPx - 1);
    const at = (row * panorama.widthPx + column) * 3;
    // The rim of a ball shows what is behind it in less than a pixel.
    if (layout === 'ball' && z === -1) return;
    expect([...panorama.data.slice(at, at + 3)]).toEqual([...color]);
  });

  test('is dark but for the lamps', () => {
    const { data, widthPx: width } = panorama;
    expect(width).toBe(layout === 'ball' ? 320 : 256);
    let lit = 0;
    let all = 0;
    for (let i = 0; i < data.length; i += 3) {
      const weight = Math.cos(((Math.floor(i / 3 / width) + 0.5) / (width / 2) - 0.5) * Math.PI);
      if (Math.max(data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0) > 128) lit += weight;
      all += weight;
    }
    // Caps of this radius cover (1 − cos r) / 2 of the sphere each.
    expect(lit / all).toBeCloseTo((LAMPS.length * (1 - Math.cos(LAMP_RAD))) / 2, 2);
  });
});

test.each([
  [1024, 512, 'equirectangular'],
  [1023, 512, 'equirectangular'],
  [1920, 1080, null],
  [4000, 800, null],
  [1, 1, 'ball'],
])('%i × %i is %s', (widthPx, heightPx, layout) => {
  expect(layoutOf(widthPx, heightPx)).toBe(layout);
});

test('says what to do about another shape', () => {
  expect(wrongShape(1920, 1080)).toContain('1920 × 1080');
  expect(wrongShape(1920, 1080)).toContain('twice as wide as high');
  expect(wrongShape(4000, 800)).toContain('until it is twice as wide as high: 4000 × 2000');
});

test('a pixel that is infinite or not a number stays alone', () => {
  const data = new Float32Array(64 * 64 * 3).fill(0.5);
  data[(20 * 64 + 30) * 3] = Number.NaN;
  data[(40 * 64 + 30) * 3] = Number.POSITIVE_INFINITY;
  const panorama = toEquirectangular({ widthPx: 64, heightPx: 64, channels: 3, data }, 'ball');
  expect([...panorama.data].every(Number.isFinite)).toBe(true);
});
