import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/room-hands.page.ts');

const near = (numbers: readonly number[]) => numbers.map((x) => expect.closeTo(x, 2));

describe('hands and controllers of a headset in the preview', () => {
  test('controllers point at the mouse, press by keys and tell what they play', async () => {
    const { hints, held, ahead, grip, pulses, up } = await page.call<Record<string, number[]>>('controllers');
    expect(hints).toEqual([expect.stringContaining('trigger'), false]);
    expect(held).toEqual({ phases: ['left hover', 'right start'], trigger: [0, 1], squeeze: [1, 0] });
    // At (300, 200) of 400 × 400 pixels: half the tangent of half the field of view to the right, at 2 m.
    const aim = [1 + Math.tan(0.7), 1.6, 0];
    const from = [1.18, 1.4, 1.65];
    const along = aim.map((x, i) => x - (from[i] ?? 0));
    expect(grip).toEqual(near(from));
    expect(ahead).toEqual(near(along.map((x) => x / Math.hypot(...along))));
    expect(pulses).toEqual([null, { strength: 0.5, durationS: 0.2 }]);
    expect(up).toEqual(['left hover', 'right end']);
  });

  test('two hands pinch; one that is lost in its pinch cancels it, and comes back without pressing', async () => {
    const { seen, shapes, refused, hint } = await page.call<{
      seen: string[][];
      shapes: Record<string, number[]>;
      refused: string;
      hint: string;
    }>('hands');
    expect(seen).toEqual([
      ['left-hand start', 'right-hand start'],
      ['left-hand hold', 'right-hand hold'],
      ['left-hand hold', 'right-hand cancel'],
      ['left-hand hold'],
      ['left-hand hold', 'right-hand hover'],
      ['left-hand end', 'right-hand hover'],
    ]);
    expect(shapes).toEqual({ relaxed: [0, 0], pinch: [1, 0], grab: [0, 1], poke: [0, 0], capture: [0, 0] });
    expect(refused).toContain('“wave”');
    expect(hint).toContain('pinch');
  });
});
