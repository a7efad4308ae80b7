import { Quaternion, Vector3 } from 'three';
import { handOf } from '../../kit/pointers.ts';
import type { Pointer, ViewFrame } from '../../kit/session.ts';

/** From one of two pointers to the other: its length in any unit, and its angle, counter-clockwise about the surface's normal. */
export interface Span {
  length: number;
  angleRad: number;
}

const scratchPoints: readonly [Vector3, Vector3] = [new Vector3(), new Vector3()];
const scratchInverse = new Quaternion();

/** Whether two pointers can pinch together: two fingers on the screen, or two hands. */
export function canPinch(a: Pointer, b: Pointer): boolean {
  return isFinger(a) ? isFinger(b) : handOf(a.by) !== null && handOf(b.by) !== null && handOf(a.by) !== handOf(b.by);
}

/**
 * Writes the span between two pointers: of fingers in the plane of the screen, of hands in the room.
 *
 * @param view The first view, whose screen the fingers touch.
 * @param rotation Of the surface; y is its normal.
 * @returns False where the pointers are too close together to tell.
 */
export function writeSpan(out: Span, a: Pointer, b: Pointer, view: ViewFrame, rotation: Quaternion): boolean {
  const [from, to] = scratchPoints;
  if (isFinger(a)) {
    writeScreenPoint(from, a.worldFromRay, view.worldFromView);
    writeScreenPoint(to, b.worldFromRay, view.worldFromView);
    to.sub(from);
    out.angleRad = Math.atan2(to.y, to.x);
  } else {
    writeHand(from, a);
    writeHand(to, b);
    to.sub(from).applyQuaternion(scratchInverse.copy(rotation).invert());
    out.angleRad = Math.atan2(-to.z, to.x);
  }
  out.length = to.length();
  return out.length > 1e-3;
}

function isFinger({ by }: Pointer): boolean {
  return by === 'screen' || by === 'mouse';
}

/** Where a ray from the eye meets the plane 1 m before it: x to the right, y up. */
function writeScreenPoint(out: Vector3, ray: Float32Array, view: Float32Array): void {
  const along = (axis: number): number =>
    (view[axis] ?? 0) * (ray[8] ?? 0) + (view[axis + 1] ?? 0) * (ray[9] ?? 0) + (view[axis + 2] ?? 0) * (ray[10] ?? 0);
  const depth = along(8);
  out.set(-along(0) / depth, -along(4) / depth, 0);
}

function writeHand(out: Vector3, { worldFromGrip, worldFromRay }: Pointer): void {
  out.fromArray(worldFromGrip ?? worldFromRay, 12);
}
