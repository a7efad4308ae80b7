import { expect, test } from '@jest/globals';
import { cropAt, cropOf, framingOf, tangentsOf } from './poster-framing.ts';

/** A projection with other angles on each side, as of a headset: tangents -1 to 2 and -0.5 to 1.5. */
const CLIP_FROM_VIEW = [2 / 3, 0, 0, 0, 0, 1, 0, 0, 1 / 3, 0.5, -1, -1, 0, 0, -0.1, 0];

test('the edges of a view are those of its frustum', () => {
  const { left, right, bottom, top } = tangentsOf(CLIP_FROM_VIEW);
  expect([left, right, bottom, top].map((edge) => Number(edge.toFixed(6)))).toEqual([-1, 2, -0.5, 1.5]);
});

test('a framing shows the same directions in a view of another size', () => {
  const crop = { x: 0.25, y: 0.25, width: 0.5, height: 0.4 };
  const tangents = tangentsOf(CLIP_FROM_VIEW);
  const shape = (0.5 * 3) / (0.4 * 2);
  const framing = framingOf(crop, tangents);
  const same = cropOf(framing, tangents, shape);
  for (const key of ['x', 'y', 'width', 'height'] as const) expect(same[key]).toBeCloseTo(crop[key]);
  const wider = cropOf(framing, { ...tangents, left: -2, right: 3 }, shape);
  expect(wider.width * 5).toBeCloseTo(crop.width * 3);
  expect(wider.x * 5 - 2).toBeCloseTo(crop.x * 3 - 1);
});

test('a crop keeps its shape and stays in the view', () => {
  expect(cropAt([0.5, 0.5], 1, 2)).toEqual({ x: 0, y: 0.25, width: 1, height: 0.5 });
  expect(cropAt([1, 0], 0.25, 2)).toEqual({ x: 0.5, y: 0, width: 0.5, height: 0.25 });
});
