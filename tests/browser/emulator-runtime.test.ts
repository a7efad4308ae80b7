import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import type { SeenBySession } from './emulator-runtime.page.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/emulator-runtime.page.ts');
});
afterAll(async () => {
  await page?.close();
});

const LIVING_ROOM = { capture: JSON.parse(readFileSync('node_modules/@iwer/sem/captures/living_room.json', 'utf8')) };
const ALL = ['camera-access', 'light-estimation'];

test.each<readonly [string, EmulatorOptions, number, readonly string[]]>([
  ['a phone in the studio', { device: 'phone', room: 'studio' }, 1, ['camera-image', 'depth', 'light-estimation']],
  [
    'a phone held upright',
    { device: 'phone', room: 'studio', sizePx: [240, 320], depth: { transform: { turnDeg: 90 } } },
    1,
    ['camera-image', 'depth', 'light-estimation'],
  ],
  [
    'a headset in a scanned living room',
    { device: 'headset', room: LIVING_ROOM, extra: ALL },
    2,
    ['camera-image', 'depth', 'light-estimation'],
  ],
  [
    'a headset with depth on the GPU',
    { device: 'headset', room: LIVING_ROOM, depth: { usages: ['gpu-optimized'], formats: ['unsigned-short'] } },
    2,
    ['depth'],
  ],
  [
    'a headset with depth as Quest Browser has it',
    { device: 'headset', room: LIVING_ROOM, depth: { usages: ['gpu-optimized'], gpuValues: 'window' } },
    2,
    ['depth'],
  ],
  ['a headset of one view', { device: 'headset', views: 1, room: LIVING_ROOM, depth: { usages: ['cpu-optimized'] } }, 1, ['depth']],
])('the runtime’s session in %s', async (_, options, views, capabilities) => {
  const seen = await page.call<SeenBySession>('seeThroughSession', options);
  expect(seen).toMatchObject({ kind: 'webxr', world: 'device', blend: 'alpha', viewCount: views, ownFramebuffer: true, glError: 0 });
  expect(seen.capabilities).toEqual(capabilities);
  expect(seen.diagnostics).toHaveLength(3 - capabilities.length);
  expect(seen.depthErrorsM).toHaveLength(5 * views);
  for (const error of seen.depthErrorsM) expect(Math.abs(error)).toBeLessThan(0.002);
  for (const meters of seen.depthsM) expect(meters).toBeGreaterThan(0.3);
  expect(seen.cameraError).toBe(0);
  expect(seen.hasReflection).toBe(capabilities.includes('light-estimation'));
  if (capabilities.includes('light-estimation')) {
    expect(seen.light).toHaveLength(6);
    for (const coefficient of seen.light?.slice(0, 3) ?? []) expect(coefficient).toBeGreaterThan(0.1);
  } else expect(seen.light).toBeNull();
  expect(seen.events).toEqual(['tracking false', 'recentered', 'tracking true', 'ended']);
});

test('nothing was complained about', () => {
  expect(page.errors).toEqual([]);
});
