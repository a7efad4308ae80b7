import { expect } from '@jest/globals';
import type { PageModule } from '../support/browser.ts';
import { passes, type Twins } from '../support/fusion-kit.ts';
import type { Difference } from './fusion.page.ts';

/** Draws pairs of programs on the page `fusion.page.ts`. */
export async function compareTwins(page: PageModule, pairs: readonly Twins[]): Promise<Difference[]> {
  return await page.call<Difference[]>(
    'compare',
    pairs.map(({ separate, fused }) => ({ separate, fused })),
  );
}

/** Expects that no channel differs by more than a step, and at most one of 10,000 at all. A failure names the nodes. */
export async function expectSameImages(page: PageModule, pairs: readonly Twins[]): Promise<void> {
  const differences = await compareTwins(page, pairs);
  const wrong = differences.flatMap(({ differing, most, channels }, i) => {
    const isSame = most <= 1 && differing <= channels / 10_000;
    return isSame ? [] : [{ files: filesOf(pairs[i]), differing, most }];
  });
  expect(wrong).toEqual([]);
}

function filesOf(pair: Twins | undefined): string[] {
  return pair === undefined ? [] : passes(pair.separate).flatMap(({ shader }) => pair.separate.shaders[shader]?.sourceMap?.sources ?? []);
}
