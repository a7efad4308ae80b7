import { expect, test } from '@jest/globals';
import { definition } from './definition.ts';

test('fixes everything before a session starts: an XR framebuffer cannot change afterwards', () => {
  expect(new Set(Object.values(definition.params).map(({ stage }) => stage))).toEqual(new Set(['structure']));
});

test('shows the world behind, smoothly, unless told otherwise', () => {
  const { antialias, background, color } = definition.params;
  expect([antialias.default, background.default]).toEqual([true, 'world']);
  // A background color that could be seen through would be no background.
  expect(color.default[3]).toBe(1);
});
