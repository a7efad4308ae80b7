import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { RoomSource } from '../../export/emulator/rooms/room-source.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import type { DepthErrors, DepthTrial } from './emulator-depth.page.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/emulator-depth.page.ts');
});
afterAll(() => page?.close());

function capture(name: string): RoomSource {
  return { capture: JSON.parse(readFileSync(`node_modules/@iwer/sem/captures/${name}.json`, 'utf8')) };
}

const OFFICE = capture('office_small');
const EYE = [0.3, 1.5, 0.4] as const;
const TARGET = [-0.6, 0.7, -1.6] as const;

function compare(trial: Partial<DepthTrial>, stride = 17): Promise<DepthErrors> {
  return page.call('compareWithRays', { eye: EYE, target: TARGET, usage: 'cpu-optimized', format: 'luminance-alpha', ...trial }, stride);
}

describe('depth is exact', () => {
  const trials: readonly (readonly [string, Partial<DepthTrial> & Pick<DepthTrial, 'options'>, number])[] = [
    ['the studio, one view', { options: { device: 'phone', room: 'studio' } }, 1],
    ['the studio, two views', { options: { device: 'headset', room: 'studio' } }, 2],
    ['a scanned living room, one view', { options: { device: 'phone', room: capture('living_room') } }, 1],
    ['a scanned living room, two views', { options: { device: 'headset', room: capture('living_room') }, format: 'float32' }, 2],
    ['a scanned office', { options: { device: 'phone', room: OFFICE } }, 1],
    ['a scanned meeting room', { options: { device: 'phone', room: capture('meeting_room') } }, 1],
    ['a scanned music room, two views', { options: { device: 'headset', room: capture('music_room') } }, 2],
    ['a scanned large office', { options: { device: 'phone', room: capture('office_large') } }, 1],
    [
      'on the GPU, an array of 16-bit integers',
      { options: { device: 'headset', room: OFFICE }, usage: 'gpu-optimized', format: 'unsigned-short' },
      2,
    ],
    ['on the GPU, an array of floats', { options: { device: 'headset', room: OFFICE }, usage: 'gpu-optimized', format: 'float32' }, 2],
    [
      'on the GPU, packed for one view',
      { options: { device: 'phone', room: OFFICE }, usage: 'gpu-optimized', format: 'luminance-alpha' },
      1,
    ],
    ['a sensor turned by 90°', { options: { device: 'phone', room: OFFICE, depth: { transform: { turnDeg: 90 } } } }, 1],
    [
      'a sensor turned, mirrored and wider than the view',
      {
        options: {
          device: 'phone',
          room: OFFICE,
          depth: { transform: { turnDeg: 270, flipX: true, covers: { x: -0.1, y: -0.2, width: 1.3, height: 1.25 } } },
        },
      },
      1,
    ],
  ];
  test.each(trials)('%s', async (_, trial, views) => {
    const found = await compare(trial);
    expect(found.granted).toEqual([trial.usage ?? 'cpu-optimized', trial.format ?? 'luminance-alpha']);
    expect(found.views).toBe(views);
    expect(found.samples).toBeGreaterThan(50);
    expect(found.medianM).toBeLessThan(0.001);
    expect(found.maxM).toBeLessThan(0.008);
    expect(found.disagreements).toBe(0);
  });
});

test('depth is this frame’s, not the one before’s', async () => {
  const [still, near, far] = await page.call<number[]>('depthAfterMoves');
  expect(still).toBeCloseTo(3, 3);
  expect(near).toBeCloseTo(4, 3);
  expect(far).toBeCloseTo(2, 3);
});

describe('the matrix of a transformed buffer finds the same place of the view', () => {
  // A post 2 m away in front of a wall at 4 m; it covers x from 0.06 to 0.41 and y from 0.16 to 0.50 of the view.
  const places = [
    [0.2, 0.4],
    [0.6, 0.4],
    [0.2, 0.75],
    [0.3, 0.25],
    [0.45, 0.45],
  ] as const;
  const expected = [2, 4, 4, 2, 4];
  test.each([
    ['upright', {}],
    ['turned by 90°', { turnDeg: 90 }],
    ['turned by 180°', { turnDeg: 180 }],
    ['turned by 270°', { turnDeg: 270 }],
    ['mirrored', { flipX: true }],
    ['upside down', { flipY: true }],
    ['wider than the view', { covers: { x: -0.25, y: -0.1, width: 1.5, height: 1.2 } }],
    ['turned, mirrored and cut', { turnDeg: 90, flipY: true, covers: { x: 0.05, y: 0.05, width: 0.9, height: 0.9 } }],
  ])('%s', async (_, transform) => {
    const found = await page.call<number[]>('depthAtPlaces', transform, places);
    found.forEach((meters, i) => {
      expect(meters).toBeCloseTo(expected[i] ?? 0, 3);
    });
  });
});
