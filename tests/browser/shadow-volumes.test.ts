import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

/** That they agree with shadow maps is proved in `tests/slow/shadow-methods.test.ts`. */
const page = useModule('tests/browser/shadow-volumes.page.ts');

const FULL = 128;
const HALF = 64;

test('a shadow volume falls where the geometry says, by all kinds of light, also around the eye', async () => {
  const inside = { middle: FULL, inNear: FULL, inFar: FULL, outNear: 0, outFar: 0, beside: 0 };
  const inSun = { ...inside, under: 0 };
  expect(await page.call('geometry')).toEqual({
    sun: inSun,
    turnedOver: inSun,
    mirrored: inSun,
    bulb: inside,
    spot: inside,
    within: { in: FULL, on: FULL },
    error: 0,
  });
});

test('shares light between lamps, follows flags and opacity, and says whose shape a picture makes', async () => {
  expect(await page.call('lamps')).toEqual({
    one: FULL,
    two: HALF,
    oneWithoutShadow: HALF,
    eight: FULL,
    none: 0,
    noCaster: 0,
    faint: 0,
    dense: FULL,
    noReceiver: 0,
    holes: FULL,
    told: ['SCR024 at casters: shape', 'SCR024 at casters: see-through'],
    error: 0,
  });
});

test('follows casters and lights while running, and leaves nothing on the GPU', async () => {
  expect(await page.call('running')).toEqual({
    alphas: { on: FULL, moved: 0, back: FULL, off: 0, turned: 0, two: HALF, empty: 0 },
    left: [0, 0, 0],
    error: 0,
  });
});

test('what casts is not darkened by its own volume, but for a breath along its outline', async () => {
  // One or two of four samples, where a surface is seen edge-on and its volume begins.
  for (const [what, { count, most }] of Object.entries(await page.call<Record<string, { count: number; most: number }>>('acne'))) {
    expect([what, count < 100, most <= FULL / 2]).toEqual([what, true, true]);
  }
});
