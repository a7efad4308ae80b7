import { expect, test } from '@jest/globals';
import { HEADS_ZOOM } from './detail.ts';
import { FAR_ZOOM, labelScale } from './use-legible-labels.ts';

test('labels of 12 px have at least 11 px on the screen, down to the zoom at which only heads are drawn', () => {
  for (const zoom of [1, 0.9, 0.75, FAR_ZOOM, 0.5, 0.4, HEADS_ZOOM]) expect(12 * zoom * labelScale(zoom)).toBeGreaterThanOrEqual(11);
  expect(labelScale(2)).toBe(1);
  expect(labelScale(0.1)).toBe(labelScale(0.2));
});
