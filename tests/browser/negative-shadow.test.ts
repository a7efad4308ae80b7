import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import type { Lamp, Surface } from './negative-shadow.page.ts';

const page = useModule('tests/browser/negative-shadow.page.ts');
const SURFACES: readonly Surface[] = ['plane', 'mesh', 'depth', 'noisy depth'];

interface Parts {
  readonly shadows: readonly number[];
  readonly lit: number;
  readonly outside: number;
  readonly error: number;
}

/** Within a tenth of what is set. */
const about = (part: number): unknown => expect.closeTo(part, -Math.log10(0.2 * part));

describe.each(SURFACES)('a negative shadow on a %s', (surface) => {
  test('is darker than the light around it as set, in linear light before it is encoded', async () => {
    for (const strength of [0.25, 0.5, 0.8]) {
      const { shadows, lit, outside, error } = await page.call<Parts>('parts', surface, [[[0.5, 1, 0], 1]], strength);
      expect([shadows[0], lit, outside, error]).toEqual([about(1 - strength), about(1), 0, 0]);
    }
  });

  test('of one light is still lit by another: by its part of the light that a matte floor receives', async () => {
    const [a, b]: [Lamp, Lamp] = [
      [[0.5, 1, 0], 2],
      [[-0.3, 1, 0.6], 1],
    ];
    const received = ([[x, y, z], irradiance]: Lamp): number => (irradiance * y) / Math.hypot(x, y, z);
    const all = received(a) + received(b);
    const { shadows, lit, outside } = await page.call<Parts>('parts', surface, [a, b], 1);
    expect([...shadows, lit, outside]).toEqual([about(received(b) / all), about(received(a) / all), about(1), 0]);
  });

  test('of each of two objects interrupts the light around its own', async () => {
    const { shadows, lit, error } = await page.call<Pick<Parts, 'shadows' | 'error'> & { lit: number[] }>(
      'twoPlates',
      surface,
      [[0.4, 1, 0.2], 1],
      0.8,
    );
    expect([...shadows, ...lit, error]).toEqual([about(0.2), about(0.2), about(1), about(1), 0]);
  });

  test('falls where the lamp throws it, within 2°', async () => {
    for (const towards of [
      [0.6, 1, 0.2],
      [-0.7, 1, -0.5],
      [0.1, 1, -0.9],
    ]) {
      expect(await page.call<number>('directionErrorDeg', surface, towards)).toBeLessThan(2);
    }
  });
});
