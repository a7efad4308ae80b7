import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import type { SessionFile } from '../../export/runtime/sessions/session-format.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import type { Shot } from './runtime-recorded.page.ts';

const chromium = useBrowser();
let page: PageModule;
let root: string;

const COLOR = { widthPx: 40, heightPx: 30, intrinsics: { fxPx: 35, fyPx: 36, cxPx: 18, cyPx: 16 } };
const DEPTH = {
  widthPx: 20,
  heightPx: 15,
  intrinsics: { fxPx: 16, fyPx: 15, cxPx: 11, cyPx: 7 },
  metresPerUnit: 0.001,
  kind: 'z',
} as const;

/** A picture whose colors say where they stand, and depth that does: 1 m and 1 cm per column and 20 cm per row. */
const color = (x: number, y: number): number[] => [x * 6, y * 8, 128];
const depthMm = (x: number, y: number): number => (x === 0 && y === 0 ? 0 : 1000 + 10 * x + 200 * y);

const SESSION: SessionFile = {
  format: 'scrim-session',
  version: 1,
  title: 'A ramp',
  color: COLOR,
  depth: DEPTH,
  frameRateHz: 10,
  frames: [0, 1, 2].map((i) => ({
    timeS: 7 + i / 10,
    color: 'color/ramp.png',
    depth: 'depth/ramp.png',
    worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, i, 1.5, 0, 1],
  })),
  light: { sphericalHarmonics: new Array<number>(27).fill(0), primaryDirectionWorld: [0, 1, 0], primaryIntensity: [1, 2, 3] },
};

function picture(): Uint8Array {
  const data = new Uint8Array(COLOR.widthPx * COLOR.heightPx * 3);
  for (let i = 0; i < data.length / 3; i++) data.set(color(i % COLOR.widthPx, Math.floor(i / COLOR.widthPx)), i * 3);
  return encode({ width: COLOR.widthPx, height: COLOR.heightPx, data, depth: 8, channels: 3 });
}

function depthImage(): Uint8Array {
  const data = Uint16Array.from({ length: DEPTH.widthPx * DEPTH.heightPx }, (_, i) =>
    depthMm(i % DEPTH.widthPx, Math.floor(i / DEPTH.widthPx)),
  );
  return encode({ width: DEPTH.widthPx, height: DEPTH.heightPx, data, depth: 16, channels: 1 });
}

async function write(name: string, session: unknown, files: Readonly<Record<string, Uint8Array>>): Promise<void> {
  for (const folder of ['color', 'depth']) await mkdir(join(root, name, folder), { recursive: true });
  await writeFile(join(root, name, 'session.json'), typeof session === 'string' ? session : JSON.stringify(session));
  for (const [path, bytes] of Object.entries(files)) await writeFile(join(root, name, path), bytes);
}

beforeAll(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-session-'));
  const files = { 'color/ramp.png': picture(), 'depth/ramp.png': depthImage() };
  await write('ramp', SESSION, files);
  const [first, second, third] = SESSION.frames;
  await write(
    'torn',
    { ...SESSION, frames: [first, { ...second, color: 'color/torn.png' }, { ...third, depth: 'depth/torn.png' }] },
    {
      ...files,
      'color/torn.png': files['color/ramp.png'].slice(0, 60),
      'depth/torn.png': files['depth/ramp.png'].slice(0, 60),
    },
  );
  await write('unreadable', '{ "format": ', {});
  await write('empty', { ...SESSION, frames: [{ ...first, color: 'color/missing.png' }] }, {});
  await write('swapped', { ...SESSION, color: { ...COLOR, widthPx: 30, heightPx: 40 } }, files);
  page = await openModule(chromium.browser, 'tests/browser/runtime-recorded.page.ts', { mounts: { '/sessions/': root } });
});

afterAll(async () => {
  await page.close();
  await rm(root, { recursive: true });
  // The browser itself says so of every missing file.
  expect(page.errors.filter((error) => !error.includes('404'))).toEqual([]);
});

interface Stepped {
  readonly ready: { readonly output: unknown; readonly diagnostics: unknown[] };
  readonly capabilities: string[];
  readonly shots: Shot[];
  readonly drawn: boolean[];
  readonly events: { readonly kind: string; readonly message?: string }[];
  readonly outside: string;
  readonly leaks: string[];
  readonly error: number;
}

/** The middle of the picture that has the shape of the canvas, worked out here once more. */
function cropOf(widthPx: number, heightPx: number): { x: number; y: number; width: number; height: number } {
  const scale = Math.min(COLOR.widthPx / widthPx, COLOR.heightPx / heightPx);
  return {
    x: (COLOR.widthPx - widthPx * scale) / 2,
    y: (COLOR.heightPx - heightPx * scale) / 2,
    width: widthPx * scale,
    height: heightPx * scale,
  };
}

const SHAPES: [number, number][] = [
  [40, 30],
  [64, 20],
  [24, 60],
];

describe.each(SHAPES)('on a canvas of %d × %d', (widthPx, heightPx) => {
  const crop = cropOf(widthPx, heightPx);
  const at: [number, number][] = [
    [1, 1],
    [widthPx - 2, heightPx - 2],
    [Math.floor(widthPx / 3), Math.floor(heightPx / 2)],
  ];
  /** Where a canvas pixel's center lies in the color picture, y down. */
  const inImage = ([x, y]: readonly [number, number]): [number, number] => [
    crop.x + ((x + 0.5) / widthPx) * crop.width,
    crop.y + (1 - (y + 0.5) / heightPx) * crop.height,
  ];

  test('the color picture covers it, cut to its shape', async () => {
    const { shots, error } = await page.call<Stepped>('step', 'sessions/ramp/', 'color', [widthPx, heightPx], [0], at);
    expect(error).toBe(0);
    at.forEach((place, i) => {
      const [px, py] = inImage(place);
      // The ramp stays a ramp between pixel centers.
      const [red = 0, green = 0, blue, alpha] = shots[0]?.pixels[i] ?? [];
      expect(Math.abs(red - (px - 0.5) * 6)).toBeLessThanOrEqual(1);
      expect(Math.abs(green - (py - 0.5) * 8)).toBeLessThanOrEqual(1);
      expect([blue, alpha]).toEqual([128, 255]);
    });
  });

  test('a point of the world is drawn where the picture shows it', async () => {
    const { shots } = await page.call<Stepped>('step', 'sessions/ramp/', 'color', [widthPx, heightPx], [0], []);
    const m = shots[0]?.clipFromView ?? [];
    const point = [0.02, 0.05, -0.8];
    const row = (r: number): number =>
      (m[r] ?? 0) * (point[0] ?? 0) + (m[r + 4] ?? 0) * (point[1] ?? 0) + (m[r + 8] ?? 0) * (point[2] ?? 0) + (m[r + 12] ?? 0);
    const drawnAt = inImage([(0.5 + (0.5 * row(0)) / row(3)) * widthPx - 0.5, (0.5 + (0.5 * row(1)) / row(3)) * heightPx - 0.5]);
    const { fxPx, fyPx, cxPx, cyPx } = COLOR.intrinsics;
    expect(drawnAt[0]).toBeCloseTo(cxPx + (fxPx * 0.02) / 0.8, 4);
    expect(drawnAt[1]).toBeCloseTo(cyPx - (fyPx * 0.05) / 0.8, 4);
  });

  test('depth lies where the depth camera measured it, to the millimeter stored', async () => {
    const { shots, error } = await page.call<Stepped>('step', 'sessions/ramp/', 'depth', [widthPx, heightPx], [0], at);
    expect(error).toBe(0);
    at.forEach((place, i) => {
      const [px, py] = inImage(place);
      const ray = [(px - COLOR.intrinsics.cxPx) / COLOR.intrinsics.fxPx, (py - COLOR.intrinsics.cyPx) / COLOR.intrinsics.fyPx] as const;
      const column = Math.floor(DEPTH.intrinsics.cxPx + DEPTH.intrinsics.fxPx * ray[0]);
      const line = Math.floor(DEPTH.intrinsics.cyPx + DEPTH.intrinsics.fyPx * ray[1]);
      const clamped = [Math.min(Math.max(column, 0), 19), Math.min(Math.max(line, 0), 14)] as const;
      const cm = depthMm(...clamped) / 10;
      expect(shots[0]?.pixels[i]).toEqual(cm === 0 ? [0, 0, 255, 255] : [Math.floor(cm / 10), cm % 10, 0, 255]);
    });
  });
});

describe('a recorded session', () => {
  test('gives each frame its own pose, time and light', async () => {
    const result = await page.call<Stepped>('step', 'sessions/ramp/', 'color', [40, 30], [0, 2, 1], []);
    expect(result.ready).toEqual({
      output: {
        title: 'A ramp',
        frames: { timesS: [0, 0.1, 0.2].map((s) => expect.closeTo(s, 6)), durationS: expect.closeTo(0.3, 6) },
        shape: 4 / 3,
      },
      diagnostics: [],
    });
    expect(result.capabilities).toEqual(['camera-image', 'depth', 'light-estimation']);
    expect(
      result.shots.map(({ index, timeS, deltaS, worldFromView, light }) => ({ index, timeS, deltaS, x: worldFromView[12], light })),
    ).toEqual([
      { index: 0, timeS: 0, deltaS: 0, x: 0, light: [1, 2, 3] },
      { index: 2, timeS: expect.closeTo(0.2, 6), deltaS: expect.closeTo(0.2, 6), x: 2, light: [1, 2, 3] },
      { index: 1, timeS: expect.closeTo(0.1, 6), deltaS: 0, x: 1, light: [1, 2, 3] },
    ]);
    expect(result.events).toEqual([{ kind: 'ended', by: 'page' }]);
    expect(result.outside).toBe('RangeError');
    expect(result.leaks).toEqual([]);
  });

  test('plays in time, starts over at the end, and jumps', async () => {
    expect(await page.call('play', 'sessions/ramp/')).toEqual([
      '0: 0.00 +0.00 at x 0',
      '1: 0.10 +0.10 at x 1',
      '2: 0.25 +0.15 at x 2',
      'reset',
      '3: 0.35 +0.10 at x 0',
      '3: 0.35 +0.00 at x 0',
      'reset',
      '1: 0.10 +0.00 at x 1',
      '1: 0.12 +0.02 at x 1',
      'ended',
    ]);
  });

  test('is there again after the graphics were lost', async () => {
    const { before, after, error } = await page.call<{ before: number[]; after: number[]; error: number }>('contextLoss', 'sessions/ramp/');
    expect(before[3]).toBe(255);
    expect(after).toEqual(before);
    expect(error).toBe(0);
  });

  test('with torn pictures says which, and goes on without them', async () => {
    const result = await page.call<Stepped>('step', 'sessions/torn/', 'depth', [40, 30], [0, 1, 2], [[20, 15]]);
    expect(result.drawn).toEqual([true, false, true]);
    expect(result.shots.map((shot) => shot.pixels[0]?.[2])).toEqual([0, 255]);
    const messages = result.events.flatMap((event) => event.message ?? []);
    expect(messages).toEqual([
      expect.stringContaining('"color/torn.png" cannot be used: the browser cannot decode it'),
      expect.stringContaining('"depth/torn.png"'),
    ]);
  });

  test.each([
    ['missing', 'cannot be read: there is no such file'],
    ['unreadable', 'not valid JSON'],
    ['empty', '"color/missing.png" cannot be used: there is no such file'],
    ['swapped', '40 × 30 pixels, but session.json specifies 30 × 40'],
  ])('whose folder is %s is refused with a reason', async (name, reason) => {
    const { output, diagnostics, leaks } = await page.call<{
      output: unknown;
      diagnostics: { code: string; message: string }[];
      leaks: string[];
    }>('open', `sessions/${name}/`);
    expect(output).toBeNull();
    expect(diagnostics).toEqual([expect.objectContaining({ code: 'SCR054', message: expect.stringContaining(reason) })]);
    expect(leaks).toEqual([]);
  });
});
