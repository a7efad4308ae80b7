import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
const models = resolve('../shared/data/models');
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/scenes-shadows.page.ts', { mounts: { '/models/': models } });
});
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

const SHADOW = [0, 0, 0, 128];
const NOTHING = [0, 0, 0, 0];
const DARK = [0, 0, 0, 255];
type Points = Record<string, number[]>;

describe('a shadow', () => {
  test('falls where the geometry says, away from the light, alike on phantoms and virtual things', async () => {
    const { catcher, scene, agreement, brighter, error } = await page.call<{
      catcher: Points;
      scene: Points;
      agreement: number;
      brighter: number;
      error: number;
    }>('geometry');
    const inside = ['middle', 'inNear', 'inFar'];
    for (const [name, value] of Object.entries(catcher)) expect([name, value]).toEqual([name, inside.includes(name) ? SHADOW : NOTHING]);
    for (const name of inside) expect([name, scene[name]]).toEqual([name, DARK]);
    expect([scene.outNear, scene.outFar]).not.toContainEqual(DARK);
    expect([agreement > 0.97, brighter, error]).toEqual([true, 0, 0]);
  });

  test('is not thrown by a lit surface on itself', async () => {
    const counts = await page.call<Record<string, number>>('acne');
    for (const [what, count] of Object.entries(counts)) expect([what, count]).toEqual([what, 0]);
  });

  test('begins at the foot of what stands on the floor', async () => {
    expect(await page.call('contact')).toEqual([128, 128, 128, 128]);
  });

  test('has its strength and color, and comes only from what casts, on what receives, by light that arrives', async () => {
    expect(await page.call('options')).toEqual({
      strengthAndColor: [204, 0, 0, 204],
      noCaster: NOTHING,
      noReceiver: NOTHING,
      virtualReceiver: NOTHING,
      twoLights: [0, 0, 0, 64],
      oneOfTwoWithoutShadow: [0, 0, 0, 64],
      fromBelow: NOTHING,
      behindWall: NOTHING,
      backOfThePlate: SHADOW,
      // A transparent object dims the light by its alpha.
      faint: [0, 0, 0, Math.round(255 * 0.5 * 0.3)],
      dense: [0, 0, 0, Math.round(255 * 0.5 * 0.7)],
      hole: NOTHING,
      besideTheHole: SHADOW,
      realOnVirtual: DARK,
      error: 0,
    });
  });

  test('follows its light and casters while running', async () => {
    // White at 45 degrees: cos 45° = 0.7071, encoded.
    const lit = 219;
    expect(await page.call('switching')).toEqual({
      on: [128, 0],
      off: [0, lit],
      again: [128, 0],
      coarser: [128, 0],
      empty: [0, lit],
      dark: [0, 0],
      error: 0,
    });
  });

  test.each(['Fox', 'RobotExpressive'])('of an animated %s is the model pressed onto the floor', async (name) => {
    if (!existsSync(`${models}/${name}.glb`)) {
      console.warn(`${models}/${name}.glb is missing: nothing was tested.`);
      return;
    }
    const { overlap, pixels, error } = await page.call<Record<string, number>>('animated', `/models/${name}.glb`);
    expect(pixels).toBeGreaterThan(300);
    expect(overlap).toBeGreaterThan(0.95);
    expect(error).toBe(0);
  });
});
