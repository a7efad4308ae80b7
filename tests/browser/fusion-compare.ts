import { expect } from '@jest/globals';
import type { PageModule } from '../support/browser.ts';
import { type GraphPlan, manyGraphs, passes, type Twins } from '../support/fusion-kit.ts';
import type { Difference } from './fusion-difference.ts';

/** Draws pairs of programs on the page `fusion.page.ts`, on all of its canvas unless a smaller size in pixels is given. */
export async function compareTwins(page: PageModule, pairs: readonly Twins[], ...size: readonly number[]): Promise<Difference[]> {
  return await page.call<Difference[]>(
    'compare',
    pairs.map(({ separate, fused }) => ({ separate, fused })),
    ...size,
  );
}

/** Expects that no channel differs by more than a step, and at most one of 10,000 at all. A failure names the nodes. */
export async function expectSameImages(page: PageModule, pairs: readonly Twins[]): Promise<void> {
  const differences = await compareTwins(page, pairs);
  const wrong = differences.flatMap((difference, i) => {
    const { differing, most } = difference;
    return isSame(difference) ? [] : [{ files: filesOf(pairs[i]), differing, most }];
  });
  expect(wrong).toEqual([]);
}

/** Expects the same of many graphs, which share two programs. Returns these. */
export async function expectSameGraphs(page: PageModule, plans: readonly GraphPlan[]): Promise<Twins> {
  const pair = manyGraphs(plans);
  const found = await page.call<Difference[]>('compareViewed', { separate: pair.separate, fused: pair.fused });
  expect(found).toHaveLength(plans.length);
  expect(found.flatMap((one, i) => (isSame(one) ? [] : [{ graph: plans[i], ...one }]))).toEqual([]);
  return pair;
}

/** Whether no channel differs by more than a step, and at most one of 10,000 at all. */
function isSame({ differing, most, channels }: Difference): boolean {
  return most <= 1 && differing <= channels / 10_000;
}

function filesOf(pair: Twins | undefined): string[] {
  return pair === undefined ? [] : passes(pair.separate).flatMap(({ shader }) => pair.separate.shaders[shader]?.sourceMap?.sources ?? []);
}
