import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/scenes-occlusion.page.ts');

describe('occlusion while drawing', () => {
  test('hides what is farther than the room, wherever the UV transform says, and nothing where depth is unknown', async () => {
    expect(await page.call('border')).toEqual({
      columns: [0, 0, 255, 255],
      cropped: [0, 0, 255, 255],
      flipped: [255, 255, 0, 0],
      turned: [0, 0, 255, 255],
      biased: [0, 255, 255, 255],
      soft: [153, 153, 153, 153],
      error: 0,
    });
  });

  test('works with every material, and compiles each once', async () => {
    const { seen, perFrame, covered, error } = await page.call<{
      seen: Record<string, [number, number]>;
      perFrame: number[];
      covered: number[];
      error: number;
    }>('everyMaterial');
    for (const [name, [left, right]] of Object.entries(seen)) expect([name, left, right > 0]).toEqual([name, 0, true]);
    // Two shaders: the border became soft, so depth is drawn first.
    expect(perFrame.slice(1)).toEqual([2, 0, 0]);
    // Without depth in a frame nothing is hidden in it.
    expect(covered).toEqual([9600, 9600, 19200, 9600]);
    expect(error).toBe(0);
  });

  test('takes each view its own room, and hides shadows as it hides objects', async () => {
    expect(await page.call('viewsAndShadows')).toEqual({ eyes: [0, 255], shadows: [0, 255], error: 0 });
  });
});
