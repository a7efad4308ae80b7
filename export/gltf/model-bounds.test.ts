import { expect, test } from '@jest/globals';
import type { GltfDocument, GltfNode } from './document.ts';
import { modelBounds } from './model-bounds.ts';

/** A model whose mesh is a box of 2 × 4 × 6. */
const boxOf = (nodes: readonly GltfNode[], scene = 0) =>
  modelBounds({
    document: {
      asset: { version: '2.0' },
      scene,
      scenes: [{ nodes: [0] }, { nodes: [1] }],
      nodes,
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ componentType: 5126, count: 8, type: 'VEC3', min: [-1, 0, -3], max: [1, 4, 3] }],
    } as GltfDocument,
    binary: new Uint8Array(0),
  });

test('the box follows the nodes of the shown scene', () => {
  const quarter = Math.SQRT1_2;
  // A quarter turn about y takes z to x, and x to −z.
  const turned: GltfNode = { children: [1], rotation: [0, quarter, 0, quarter], translation: [10, 0, 0] };
  const found = boxOf([turned, { mesh: 0, scale: [1, 0.5, 1] }]);
  for (const [axis, [min, max]] of [
    [7, 13],
    [0, 2],
    [-1, 1],
  ].entries()) {
    expect(found?.min[axis]).toBeCloseTo(min ?? Number.NaN, 5);
    expect(found?.max[axis]).toBeCloseTo(max ?? Number.NaN, 5);
  }
  expect(boxOf([turned, { mesh: 0 }], 1)).toEqual({ min: [-1, 0, -3], max: [1, 4, 3] });
});

test('a model without a mesh has none, and nodes that list each other twice end', () => {
  expect(boxOf([{}, {}])).toBeNull();
  const chain = Array.from({ length: 40 }, (_, i): GltfNode => ({ children: [i + 1, i + 1] }));
  expect(boxOf([...chain, { mesh: 0, children: [0] }])).toEqual({ min: [-1, 0, -3], max: [1, 4, 3] });
});
