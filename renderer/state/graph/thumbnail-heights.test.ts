import { expect, test } from '@jest/globals';
import { THUMBNAIL_HEIGHT } from './node-shape.ts';
import { type BareBox, thumbnailHeights } from './thumbnail-heights.ts';

const node = (id: string, x: number, y: number, hasLayer = true): BareBox => ({ id, x, y, width: 184, height: 64, hasLayer });

test('a thumbnail takes the free space below its node, up to its full height, and none where there is too little', () => {
  const nodes = [
    node('free', 0, 0),
    node('beside', 200, 0),
    node('below', 200, 150),
    node('tight', 400, 0),
    node('close', 400, 80, false),
    node('objects', 0, 400, false),
  ];
  const heights = thumbnailHeights(nodes, [], []);
  expect(heights.get('free')).toBe(THUMBNAIL_HEIGHT);
  // 150 minus the height of the node and a gap.
  expect(heights.get('beside')).toBe(74);
  expect(heights.has('tight')).toBe(false);
  expect(heights.has('objects')).toBe(false);
});

test('a thumbnail covers no note, and stays in the frame of its node', () => {
  const note = { x: 100, y: 140, width: 200, height: 96 };
  expect(thumbnailHeights([node('a', 0, 0)], [note], []).get('a')).toBe(64);
  const frame = { x: -20, y: -20, width: 300, height: 160 };
  expect(thumbnailHeights([node('a', 0, 0)], [], [frame]).get('a')).toBe(64);
});
