import { expect, test } from '@jest/globals';
import { judgeDepth, type SentDepth } from './judge-depth.ts';

const PINHOLE = { widthPx: 8, heightPx: 6, fxPx: 4, fyPx: 4, cxPx: 4, cyPx: 3, isAround: false };
/** A wall 2 m ahead, in 5,000ths of a meter. */
const WALL: SentDepth = {
  name: 'a.jpg',
  usualUnit: 'mm',
  pinhole: PINHOLE,
  values: Array.from({ length: 48 }, () => 10_000),
  surface: { kind: 'mesh', values: Array.from({ length: 48 }, () => 2) },
};
const DETECT = { unit: null, kind: null };

test('says what depth files give with the detected unit', () => {
  const { scale, problem, medianM, farthestM, offSurface, plan } = judgeDepth([WALL], DETECT, 1, false);
  expect(scale).toMatchObject({ unit: 0.0002, kind: 'z' });
  expect([problem, medianM, farthestM, offSurface]).toEqual([null, expect.closeTo(2, 5), expect.closeTo(2, 5), expect.closeTo(0, 5)]);
  // From above, a wall is a line.
  expect(new Set(plan.map(([, aheadM]) => aheadM.toFixed(4)))).toEqual(new Set(['2.0000']));
});

test('shows a wrong unit by its distance and a wrong kind by a bent wall', () => {
  const wrongUnit = judgeDepth([WALL], { unit: 'mm', kind: 'z' }, 1, false);
  expect([wrongUnit.scale, wrongUnit.medianM]).toEqual([null, 10]);
  expect(wrongUnit.problem).toBe(
    'The depth of a.jpg is 5 times that of the mesh with the unit mm. Choose another unit of depth, or import it without depth.',
  );
  const wrongKind = judgeDepth([WALL], { unit: 0.0002, kind: 'ray' }, 1, false);
  expect(wrongKind.offSurface).toBeGreaterThan(0.1);
  expect(new Set(wrongKind.plan.map(([, aheadM]) => aheadM.toFixed(4))).size).toBeGreaterThan(3);
});

test('takes the usual unit where nothing tells it', () => {
  expect(judgeDepth([{ ...WALL, surface: null }], DETECT, 1, true)).toMatchObject({ scale: { unit: 'mm' }, offSurface: null, medianM: 10 });
});
