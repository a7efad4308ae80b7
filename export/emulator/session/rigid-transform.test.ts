import { expect, test } from '@jest/globals';
import { XRRigidTransform } from 'iwer';
import { EmulatedRigidTransform } from './rigid-transform.ts';

// Node has no DOMPointReadOnly; it is a container of four numbers.
class Point {
  constructor(
    readonly x = 0,
    readonly y = 0,
    readonly z = 0,
    readonly w = 1,
  ) {}
}
Object.assign(globalThis, { DOMPointReadOnly: Point });

const make = EmulatedRigidTransform as unknown as new (position?: object, orientation?: object) => XRRigidTransform;

test('what is left out is 0, and w is 1', () => {
  expect(new make({ z: -2 }, { y: 1, w: 0 })).toMatchObject({
    position: { x: 0, y: 0, z: -2, w: 1 },
    orientation: { x: 0, y: 1, z: 0, w: 0 },
  });
  expect([...new make().matrix]).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
});

test('a quaternion is made a unit one, and the inverse leads back', () => {
  const transform = new make({ x: 1, y: 2, z: 3 }, { x: 0, y: 2, z: 0, w: 2 });
  expect(transform.orientation.y).toBeCloseTo(Math.SQRT1_2, 6);
  expect(transform.inverse.inverse).toBe(transform);
  // By a quarter turn about y, (1, 2, 3) − (1, 2, 3) is the origin.
  const m = transform.inverse.matrix;
  const at = (i: number): number => m[i] ?? 0;
  for (const row of [0, 1, 2]) expect(at(row) + at(row + 4) * 2 + at(row + 8) * 3 + at(row + 12)).toBeCloseTo(0, 5);
});

test.each([
  [{ x: 1, w: 2 }, undefined, 'TypeError'],
  [{ w: 0 }, undefined, 'TypeError'],
  [{ x: Number.NaN }, undefined, 'TypeError'],
  [undefined, { x: Number.POSITIVE_INFINITY }, 'TypeError'],
  [undefined, { x: 0, y: 0, z: 0, w: 0 }, 'InvalidStateError'],
])('%j and %j: %s', (position, orientation, name) => {
  expect(() => new make(position, orientation)).toThrow(expect.objectContaining({ name }));
});

test('the device’s own transforms are instances too', () => {
  expect(new XRRigidTransform()).toBeInstanceOf(EmulatedRigidTransform);
});
