import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/scenes-three.page.ts');

describe('what scenes rest on in three.js', () => {
  test('a target takes a framebuffer from outside, its viewport, and encodes sRGB', async () => {
    const { toLayer, toCanvas, error } = await page.call<{ toLayer: number[][][]; toCanvas: number[][][]; error: number }>('properties');
    const gray = [128, 128, 128, 255];
    const nothing = [0, 0, 0, 0];
    expect(toLayer).toEqual([
      [nothing, nothing],
      [nothing, gray],
    ]);
    expect(toCanvas).toEqual([
      [nothing, gray],
      [nothing, nothing],
    ]);
    expect(error).toBe(0);
  });

  test('a layer holds what three.js itself draws on a transparent canvas', async () => {
    const result = await page.call<{ drawn: number }>('sameAsPlain');
    expect(result).toMatchObject({ difference: { pixels: 0 }, again: { pixels: 0, largest: 0 }, error: 0 });
    expect(result.drawn).toBeGreaterThan(3000);
  });
});
