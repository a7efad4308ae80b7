import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import type { Contours } from './suggestive-contours.page.ts';

const page = useModule('tests/slow/suggestive-contours.page.ts');

test.each([
  [-1.1, [0.4, 0.3, 1.9], 64],
  // Too dense for lines of edges.
  [-1.15, [-0.2, 0.3, 1.9], 210],
] as const)('suggestive contours of a torus turned by %d are where its formula has them', async (turnRad, eye, segments) => {
  const { wanted, found, ink, right } = await page.call<Contours>('contours', turnRad, eye, segments);
  expect(wanted).toBeGreaterThan(50);
  expect(found / wanted).toBeGreaterThan(0.9);
  expect(right / ink).toBeGreaterThan(0.9);
});
