import { describe, expect, test } from '@jest/globals';
import type { ModelBounds } from '../../../export/gltf/model-bounds.ts';
import type { FloorPoint } from './floor-point.ts';
import { rowOnFloor, standOnFloor, visibleScale } from './stand-on-floor.ts';

test('the lowest point of a model stands on the floor, and its middle over the point', () => {
  const { positionM, scale } = standOnFloor([1, -2], { min: [-0.1, -0.2, 0], max: [0.3, 0.4, 0.4] });
  expect(scale).toBe(1);
  expect(positionM).toEqual([0.9, 0.2, -2.2]);
});

test('a model of 154 m is drawn at a two-hundredth, and still stands on the floor', () => {
  const { positionM, scale } = standOnFloor([0, -1], { min: [-12, 0, -88], max: [12, 78, 66] });
  expect(scale).toBe(0.005);
  // Its middle in z is at −11 units.
  expect(positionM).toEqual([0, 0, -0.945]);
});

test.each([
  [0, 1],
  [0.1, 1],
  [1, 1],
  [1.5, 0.5],
  [8, 0.1],
  [300, 0.002],
  [0.03, 10],
  // The greatest scale of a Transform.
  [0.006, 10],
])('a model of %d m gets the round scale %d', (sizeM, scale) => {
  expect(visibleScale(sizeM)).toBe(scale);
});

test('a model of unknown size stands at the point as it is', () => {
  expect(standOnFloor([0.1234, -2.5], null)).toEqual({ positionM: [0.123, 0, -2.5], scale: 1 });
});

/** A box of these sizes in x, y and z, away from the origin of its model. */
const boxOf = (x: number, y: number, z: number): ModelBounds => ({ min: [3, -1, 2], max: [3 + x, y - 1, 2 + z] });

/** Where the box of a model lies in the world, in x and z. */
function standing(point: FloorPoint, { min, max }: ModelBounds) {
  const { positionM, scale } = standOnFloor(point, { min, max });
  const ends = (axis: 0 | 2) => [positionM[axis] + scale * min[axis], positionM[axis] + scale * max[axis]] as const;
  return { x: ends(0), z: ends(2) };
}

describe('several models', () => {
  // Among them a thin one between two wide ones, a large one and a small one.
  const models = [boxOf(1, 0.4, 0.1), boxOf(0.1, 0.1, 0.1), boxOf(0.1, 1, 1), boxOf(40, 20, 30), boxOf(0.01, 0.02, 0.01)];

  test.each([0, 30, 45, 90, 135, 200, 270])('stand in a row at %d°, and their boxes are apart', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const row = rowOnFloor([1, -2], [Math.cos(angle), Math.sin(angle)], models);
    const boxes = row.flatMap((point, i) => (models[i] ? [standing(point, models[i])] : []));
    for (const [i, a] of boxes.entries()) {
      for (const b of boxes.slice(i + 1)) {
        const gaps = [b.x[0] - a.x[1], a.x[0] - b.x[1], b.z[0] - a.z[1], a.z[0] - b.z[1]];
        expect(Math.max(...gaps)).toBeGreaterThan(0.09);
      }
    }
    const [[firstX, firstZ], [lastX, lastZ]] = [row[0] ?? [0, 0], row.at(-1) ?? [0, 0]];
    expect([(firstX + lastX) / 2, (firstZ + lastZ) / 2]).toEqual([expect.closeTo(1, 9), expect.closeTo(-2, 9)]);
  });

  test('are 10 cm apart where the row goes along an axis', () => {
    const row = rowOnFloor([0, -1], [1, 0], [boxOf(0.4, 1, 0.2), boxOf(0.8, 1, 0.2), null]);
    expect(row.map(([x, z]) => [Number(x.toFixed(6)), z])).toEqual([
      [-0.725, -1],
      [-0.025, -1],
      [0.725, -1],
    ]);
  });

  test('one alone stands at the point', () => {
    expect(rowOnFloor([0.5, -1], [0, 1], [boxOf(1, 1, 1)])).toEqual([[0.5, -1]]);
    expect(rowOnFloor([0.5, -1], [0, 1], [])).toEqual([]);
  });
});
