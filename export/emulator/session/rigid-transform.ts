import { XRRigidTransform } from 'iwer';

/** What pages make, as WebXR Device API §8.1 checks it: iwer takes every number, and makes NaN of what is left out. */
export const EmulatedRigidTransform: typeof XRRigidTransform = new Proxy(XRRigidTransform, {
  construct: (Base, [position, orientation]: (DOMPointInit | undefined)[]) =>
    new Base(position && checkPosition(position), orientation && checkOrientation(orientation)),
});

type Point = ConstructorParameters<typeof XRRigidTransform>[0];

function checkPosition({ x = 0, y = 0, z = 0, w = 1 }: DOMPointInit): Exclude<Point, undefined> {
  checkFinite('position', x, y, z, w);
  if (w !== 1) throw new TypeError(`The position of a rigid transform has w = 1, but this one has w = ${w}.`);
  return new DOMPointReadOnly(x, y, z, w);
}

function checkOrientation({ x = 0, y = 0, z = 0, w = 1 }: DOMPointInit): Exclude<Point, undefined> {
  checkFinite('orientation', x, y, z, w);
  if (Math.hypot(x, y, z, w) === 0) {
    throw new DOMException('The orientation of a rigid transform is a quaternion, and all of this one is 0.', 'InvalidStateError');
  }
  return new DOMPointReadOnly(x, y, z, w);
}

function checkFinite(what: string, ...numbers: readonly number[]): void {
  const bad = numbers.find((value) => !Number.isFinite(value));
  if (bad !== undefined) throw new TypeError(`The ${what} of a rigid transform holds ${bad}, which is no finite number.`);
}
