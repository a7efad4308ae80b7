import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/runtime-context.page.ts');

const NO_ERROR = 0;
const GREEN = [0, 255, 0, 255];

test('a lost context comes back with the picture and the params it had', async () => {
  expect(await page.call('contextLoss')).toEqual({
    whileLost: 0,
    result: { outcome: 'playing', errors: [] },
    shown: GREEN,
    error: NO_ERROR,
  });
});

test('values and the nodes that make them outlive lost contexts, and nothing is left of what did not', async () => {
  expect(await page.call('stateOutlivesContext')).toEqual({
    counted: [10, 20, 30, 40, 50, 53, 58, 5],
    sameObjects: true,
    // Once, and once more after the reset.
    made: 2,
    painted: 7,
    live: 0,
    diagnostics: [],
    error: NO_ERROR,
  });
});

test('no hit test and no anchor is left open by a node that is removed, nor by a lost context', async () => {
  const round = [
    [1, 1],
    [1, 1],
    [0, 0],
  ];
  expect(await page.call('spatialCounts')).toEqual({ counted: [[0, 0], ...round, ...round, ...round], error: NO_ERROR });
});
