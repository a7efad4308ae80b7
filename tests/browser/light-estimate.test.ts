import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/light-estimate.page.ts');

describe('the light estimate', () => {
  test.each([1, 0.5])(
    'lights a white matt ball as nine coefficients say, at intensity %f: within 1/255 in every pixel',
    async (intensity) => {
      const { count, worst, range, error } = await page.call<Record<string, number>>('lambert', intensity);
      console.log(`Lambert ball under nine coefficients × ${intensity}: ${count} pixels, off by ${worst?.toFixed(3)} of 255 at most`);
      expect(count).toBeGreaterThan(3000);
      expect(range).toBeGreaterThan(40);
      expect(worst).toBeLessThanOrEqual(1);
      expect(error).toBe(0);
    },
  );

  test('is mirrored by metal where the device gives a cube map, face by face, and again when that changes', async () => {
    const { first, second, turned, without, colors, leaked, error } = await page.call<{
      first: number[][];
      second: number[][];
      turned: number[][];
      without: number[];
      colors: number[][];
      leaked: number;
      error: number;
    }>('mirrors');
    const near = (color: number[] | undefined) => color?.map((value) => Math.round(value / 12));
    first.forEach((seen, i) => {
      expect([i, near(seen)]).toEqual([i, near(colors[i])]);
    });
    second.forEach((seen, i) => {
      expect([i, near(seen)]).toEqual([i, near(colors[(i + 1) % 6])]);
    });
    // Sides as they are listed: +x shows what lay towards -z, and so on around.
    turned.forEach((seen, i) => {
      expect([i, near(seen)]).toEqual([i, near(colors[[5, 4, 2, 3, 0, 1][i] ?? 0])]);
    });
    // The coefficients alone, straight up: 0.2821 · 1.1 + 0.4886 · 0.3 − 0.3154 · −0.1 · 1 − 0.5463 · 0.06 = 0.455, encoded 180.
    expect(Math.abs((without[0] ?? 0) - 180)).toBeLessThanOrEqual(3);
    expect([leaked, error]).toEqual([0, 0]);
  });

  test('that changes alone draws what matt surfaces receive, six faces, and leaves what is mirrored as it is', async () => {
    interface Shot {
      readonly draws: number;
      readonly buffers: number;
      readonly matt: number[];
      readonly shiny: number[];
    }
    const { still, dimmed, mirroredAnew, without, brightened, error } = await page.call<
      Record<'still' | 'dimmed' | 'mirroredAnew' | 'without' | 'brightened', Shot> & { error: number }
    >('redrawn');
    const extra = (shot: Shot) => [shot.draws - still.draws, shot.buffers];
    expect(extra(dimmed)).toEqual([6, 0]);
    expect(dimmed.matt[0]).toBeLessThan((still.matt[0] ?? 0) - 20);
    expect(dimmed.shiny).toEqual(still.shiny);
    // Six faces of the cube map and of four levels.
    expect(extra(mirroredAnew)).toEqual([30, 0]);
    expect(mirroredAnew.matt).toEqual(dimmed.matt);
    expect(mirroredAnew.shiny).not.toEqual(dimmed.shiny);
    // Without a cube map, coefficients are what is mirrored too.
    expect(extra(without)).toEqual([24, 0]);
    expect(extra(brightened)).toEqual([24, 0]);
    expect(brightened.matt).toEqual(still.matt);
    expect(brightened.shiny[0]).toBeGreaterThan((without.shiny[0] ?? 0) + 20);
    expect(error).toBe(0);
  });

  test('throws shadows away from the strongest light', async () => {
    // 0.5 m above the floor, the shadow's middle lies 0.5 m · tan of the light's angle from the vertical away.
    const towards = [
      [1, 1, 0],
      [-1, 2, 0],
      [0, 1, 1],
      [0.5, 1, -0.5],
    ];
    const found = await page.call<{ x: number; z: number }[]>('shadowSides', towards);
    found.forEach(({ x, z }, i) => {
      const [lightX = 0, lightY = 1, lightZ = 0] = towards[i] ?? [];
      expect(x).toBeCloseTo((-0.5 * lightX) / lightY, 1);
      expect(z).toBeCloseTo((-0.5 * lightZ) / lightY, 1);
    });
  });

  test.each([true, false])('measures the mean of the camera picture as the view shows it, in linear light (held: %s)', async (held) => {
    const { whole, left, none, left_over, error } = await page.call<{
      whole: number[] | null;
      left: number[] | null;
      none: number[] | null;
      left_over: number;
      error: number;
    }>('cameraMeans', held);
    const gray = ((128 / 255 + 0.055) / 1.055) ** 2.4;
    // The mean goes through 8 bits.
    expect(whole?.[0]).toBeCloseTo(0.5, 2);
    expect(whole?.[1]).toBeCloseTo(gray, 2);
    expect(whole?.[2]).toBe(0);
    expect(left?.[0]).toBeCloseTo(1, 2);
    expect(none).toBeNull();
    expect([left_over, error]).toEqual([0, 0]);
  });
});
