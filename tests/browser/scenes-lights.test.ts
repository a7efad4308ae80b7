import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/scenes-lights.page.ts');

/** IEC 61966-2-1, to eight bits. */
function encode(linear: number): number {
  const x = Math.min(1, linear);
  return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

/** Light on the floor at `x` under a lamp of 2 cd at 0.8 m: I cos / d², of which a white matt surface sends back 1/π. */
function expectedRed(x: number, rangeM: number): number {
  const distance = Math.hypot(x, 0.8);
  const fade = rangeM === 0 ? 1 : Math.max(0, 1 - (distance / rangeM) ** 4) ** 2;
  return encode(((2 / distance ** 2) * (0.8 / distance) * fade) / Math.PI);
}

describe('a point light', () => {
  test.each([0, 1.2])('falls off with the square of the distance, to its range of %d m, as three.js has it', async (rangeM) => {
    const { places, error } = await page.call<{ places: { x: number; red: number }[]; error: number }>('falloff', rangeM);
    const three = await page.call<number[]>('falloffOfThree', rangeM);
    places.forEach(({ x, red }, i) => {
      expect([i, Math.abs(red - expectedRed(x, rangeM)) <= 1]).toEqual([i, true]);
      expect([i, Math.abs(red - (three[i] ?? 0)) <= 1]).toEqual([i, true]);
    });
    // The formula has something to say: the values differ, and the range ends the light.
    expect(places[0]?.red).toBeGreaterThan(200);
    expect(places.at(-1)?.red).toBe(rangeM === 0 ? expectedRed(places.at(-1)?.x ?? 0, 0) : 0);
    expect(error).toBe(0);
  });

  test('throws shadows to all six sides', async () => {
    const { result, error } = await page.call<{ result: Record<string, [number, number]>; error: number }>('allSides');
    for (const [side, [behind, beside]] of Object.entries(result)) expect([side, behind, beside > 150]).toEqual([side, 0, true]);
    expect([Object.keys(result).length, error]).toEqual([6, 0]);
  });
});

describe('a spot light', () => {
  test('ends at its angle', async () => {
    const { share, meters, error } = await page.call<{ share: number[]; meters: number[]; error: number }>('cone', 0);
    // 60 degrees wide, 1 m above the floor.
    const edgeM = Math.tan(Math.PI / 6);
    const pixelM = (meters[1] ?? 0) - (meters[0] ?? 0);
    meters.forEach((x, i) => {
      if (Math.abs(Math.abs(x) - edgeM) < pixelM) return;
      const expected = Math.abs(x) < edgeM ? 1 : 0;
      expect([x, Math.abs((share[i] ?? 0) - expected) < 0.02]).toEqual([x, true]);
    });
    expect([meters.some((x) => x > edgeM), error]).toEqual([true, 0]);
  });

  test('comes up over its penumbra', async () => {
    const { share, meters } = await page.call<{ share: number[]; meters: number[] }>('cone', 0.5);
    meters.forEach((x, i) => {
      // Smooth between the cosines of the whole angle and of half of it.
      const [edge, full] = [Math.cos(Math.PI / 6), Math.cos(Math.PI / 12)];
      const t = Math.min(1, Math.max(0, (1 / Math.hypot(x, 1) - edge) / (full - edge)));
      expect([x, Math.abs((share[i] ?? 0) - t * t * (3 - 2 * t)) < 0.03]).toEqual([x, true]);
    });
  });
});

type Points = Record<string, number[]>;

describe.each(['spot', 'point'])('the shadow of a %s light', (kind) => {
  test('falls where the geometry says, alike on phantoms and virtual things', async () => {
    const { catcher, scene, lit, error } = await page.call<{ catcher: Points; scene: Points; lit: Points; error: number }>(
      'lampShadow',
      kind,
    );
    const dark = ['middle', 'inside', 'insideFar'];
    for (const name of Object.keys(catcher)) {
      expect([name, catcher[name]?.[3]]).toEqual([name, dark.includes(name) ? 128 : 0]);
      expect([name, scene[name]?.[0]]).toEqual([name, dark.includes(name) ? 0 : lit[name]?.[0]]);
    }
    expect([lit.middle?.[0], error]).toEqual([expect.any(Number), 0]);
    expect(lit.middle?.[0]).toBeGreaterThan(100);
  });

  test('is not thrown by a lit surface on itself', async () => {
    expect(await page.call('acne', kind)).toEqual({ darker: 0, caught: 0, error: 0 });
  });
});

describe('several lights at once', () => {
  test('each throw their own shadow, and share what is dark', async () => {
    const { catcher, scene, error } = await page.call<Record<'catcher' | 'scene', Record<string, number>> & { error: number }>('several');
    // Irradiance on the floor, by hand: spot and bulb 3 cd from 1.5 m, the sun 1. Each plate hides the sun and the lamp above it.
    const under = 3 / 1.5 ** 2;
    const across = (3 * 1.5) / Math.hypot(1.2, 1.5) ** 3;
    // The spot's cone ends 0.87 m from its middle: the floor under the bulb is 1.2 m away.
    expect(Math.abs((catcher.underSpot ?? 0) - (128 * (under + 1)) / (under + 1 + across))).toBeLessThanOrEqual(1);
    expect(Math.abs((catcher.underBulb ?? 0) - 128)).toBeLessThanOrEqual(1);
    expect(catcher.between).toBe(0);
    expect(Math.abs((scene.underSpot ?? 0) - encode(across / Math.PI))).toBeLessThanOrEqual(1);
    expect(scene.underBulb).toBe(0);
    const middle = (3 * 1.5) / Math.hypot(0.6, 1.5) ** 3;
    expect(Math.abs((scene.between ?? 0) - encode((2 * middle + 1) / Math.PI))).toBeLessThanOrEqual(1);
    expect(error).toBe(0);
  });

  test('beyond six shadows the others cast none, and the layer says so', async () => {
    const { reports, seven, one, error } = await page.call<{ reports: string[]; seven: number; one: number; error: number }>('tooMany');
    expect([...new Set(reports)]).toEqual(['7 lights cast shadows, but a scene supports 6. The first 6 cast shadows, the others do not.']);
    expect([seven, error]).toEqual([one, 0]);
  });

  test('leave nothing behind on the GPU', async () => {
    const { before, after } = await page.call<{ before: unknown; after: unknown }>('leaks');
    expect(after).toEqual(before);
  });
});
