import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/webxr-floor.page.ts');

interface Floorless {
  /** Heights of the eyes: when the visitor has re-centered, and 20 cm higher. */
  readonly first: number;
  readonly last: number;
  readonly resets: number;
  readonly floor: readonly number[];
  readonly sky: readonly number[];
}

function blueness([red = 0, , blue = 0]: readonly number[]): number {
  return blue - red;
}

describe('where the browser does not know the floor', () => {
  test.each(['immersive-ar', 'immersive-vr'] as const)('it lies 1.6 m below where the eyes began: %s', async (mode) => {
    const { first, last, resets, floor, sky } = await page.call<Floorless>('withoutFloor', mode);
    expect(first).toBeCloseTo(1.6, 5);
    expect(last).toBeCloseTo(1.8, 5);
    expect(resets).toBe(1);
    if (mode === 'immersive-vr') expect(blueness(sky)).toBeGreaterThan(blueness(floor) + 5);
  });
});
