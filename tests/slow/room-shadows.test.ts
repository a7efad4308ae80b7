import { readdirSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Cracks } from './room-shadows.page.ts';

const PAGE = 'tests/slow/room-shadows.page.ts';
const SEED = 7;

describe('a shadow over a floor and a block, caught by depth alone', () => {
  const page = useModule(PAGE);

  test.each([
    [160, 90],
    [640, 480],
  ])('has no cracks along the steps, and no grains by the noise of a sensor of %d × %d', async (columns, rows) => {
    const clean = await page.call<Cracks>('block', columns, rows, null);
    const noisy = await page.call<Cracks>('block', columns, rows, SEED);
    expect([clean.part, clean.error, noisy.error]).toEqual([0, 0, 0]);
    expect(noisy.part).toBeLessThan(0.001);
  });
});

describeWithData('a shadow over a recorded room, caught by depth alone', 'sessions/icl-livingroom', (recording) => {
  const page = useModule(PAGE, { mounts: { '/recording/': recording } });

  // What is left faces down, or away: undersides of a seat and a shelf.
  test.each([
    [160, 120, null, 0.003],
    [160, 120, SEED, 0.008],
    [640, 480, SEED, 0.008],
  ] as const)('is whole, with a sensor of %d × %d and noise by %s', async (columns, rows, seed, most) => {
    const depths = readdirSync(`${recording}/depth`).sort();
    for (const frame of [20, 40]) {
      const { known, part, error } = await page.call<Cracks>('recorded', `/recording/depth/${depths[frame]}`, columns, rows, seed);
      console.info(`Frame ${frame}, ${columns} × ${rows}, noise ${seed ?? 'none'}: ${(100 * part).toFixed(3)} % of the shadow missing.`);
      expect(error).toBe(0);
      expect(known).toBeGreaterThan(100_000);
      expect(part).toBeLessThan(most);
    }
  });
});
