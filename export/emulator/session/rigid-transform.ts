import { XRRigidTransform } from 'iwer';

/** `XRRigidTransform` with the checks of WebXR Device API §8.1 on the page's arguments, which iwer omits. */
export const EmulatedRigidTransform: typeof XRRigidTransform = new Proxy(XRRigidTransform, {
  construct: (Base, [position, orientation]: (DOMPointInit | undefined)[]) =>
    new Base(position && checkPosition(position), orientation && checkOrientation(orientation)),
});

type Point = ConstructorParameters<typeof XRRigidTransform>[0];

function checkPosition({ x = 0, y = 0, z = 0, w = 1 }: DOMPointInit): Exclude<Point, undefined> {
  checkFinite('position', x, y, z, w);
  if (w !== 1) throw new TypeError(`The position of a rigid transform must have w = 1, but has w = ${w}.`);
  return new DOMPointReadOnly(x, y, z, w);
}

function checkOrientation({ x = 0, y = 0, z = 0, w = 1 }: DOMPointInit): Exclude<Point, undefined> {
  checkFinite('orientation', x, y, z, w);
  if (Math.hypot(x, y, z, w) === 0) {
    throw new DOMException('The orientation of a rigid transform must not have length 0.', 'InvalidStateError');
  }
  return new DOMPointReadOnly(x, y, z, w);
}

function checkFinite(what: string, ...numbers: readonly number[]): void {
  const bad = numbers.find((value) => !Number.isFinite(value));
  if (bad !== undefined) throw new TypeError(`The ${what} of a rigid transform contains ${bad}, which is not finite.`);
}

/** Copies sixteen numbers into a matrix of iwer, whose type is not an array type. */
export function writeMatrix(target: { [index: number]: number }, source: ArrayLike<number>): void {
  for (let i = 0; i < 16; i++) target[i] = source[i] ?? 0;
}
