import { handOf } from './pointers.ts';
import type { Pointer, ViewFrame } from './session.ts';

/** The line from one pointer to another: its length and its angle. */
export interface PointerSpan {
  /** Length, meters. For fingers on the screen it is measured in the plane 1 m in front of the eye; for hands, in the room. */
  lengthM: number;
  /**
   * Angle, counterclockwise, radians. For fingers it is measured on the screen; for hands, about the vertical or about the y axis of a
   * surface.
   */
  angleRad: number;
}

/** A quaternion of length 1. */
interface Rotation {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly w: number;
}

const UPRIGHT: Rotation = { x: 0, y: 0, z: 0, w: 1 };
/** A shorter span counts as none, because it has no clear angle. */
const LEAST_M = 1e-3;

// Filled and read within one call.
const scratchFrom = new Float64Array(3);
const scratchTo = new Float64Array(3);

/**
 * Whether a pointer is bound to the screen: a finger or the mouse. Its ray turns with the view.
 *
 * @example
 * const space = isOnScreen(pointer) ? view.worldFromView : startView;
 */
export function isOnScreen({ by }: Pointer): boolean {
  return by === 'screen' || by === 'mouse';
}

/**
 * Whether two pointers can pinch together: two on the screen, or two hands.
 *
 * @example
 * if (canPinch(first, pointer)) second = pointer.id;
 */
export function canPinch(a: Pointer, b: Pointer): boolean {
  if (isOnScreen(a)) return isOnScreen(b);
  const hand = handOf(a.by);
  const other = handOf(b.by);
  return hand !== null && other !== null && hand !== other;
}

/**
 * Writes the span between two pointers.
 *
 * @param view The first view, on whose screen the fingers are.
 * @param surface The rotation of the surface about whose y axis the angle of hands is measured; absent: about the vertical.
 * @returns False where the pointers are too close together to tell; `out` is then as it was.
 *
 * @example
 * if (writePointerSpan(span, first, second, frame.views[0])) scale *= span.lengthM / lastLengthM;
 */
export function writePointerSpan(out: PointerSpan, a: Pointer, b: Pointer, view: ViewFrame, surface: Rotation = UPRIGHT): boolean {
  const areOnScreen = isOnScreen(a);
  if (areOnScreen) {
    writeScreenPoint(scratchFrom, a, view);
    writeScreenPoint(scratchTo, b, view);
  } else {
    writeHandPoint(scratchFrom, a);
    writeHandPoint(scratchTo, b);
  }
  const x = (scratchTo[0] ?? 0) - (scratchFrom[0] ?? 0);
  const y = (scratchTo[1] ?? 0) - (scratchFrom[1] ?? 0);
  const z = (scratchTo[2] ?? 0) - (scratchFrom[2] ?? 0);
  const lengthM = Math.hypot(x, y, z);
  if (!(lengthM > LEAST_M)) return false;
  out.lengthM = lengthM;
  out.angleRad = areOnScreen ? Math.atan2(y, x) : angleAboutY(surface, x, y, z);
  return true;
}

/** The angle of a vector about the y axis of a rotated frame, from the frame's x axis to its -z axis. */
function angleAboutY({ x: p, y: q, z: r, w }: Rotation, x: number, y: number, z: number): number {
  const alongX = (1 - 2 * (q * q + r * r)) * x + 2 * (p * q + r * w) * y + 2 * (p * r - q * w) * z;
  const alongZ = 2 * (p * r + q * w) * x + 2 * (q * r - p * w) * y + (1 - 2 * (p * p + q * q)) * z;
  return Math.atan2(-alongZ, alongX);
}

/** Writes the point where a pointer's ray meets the plane 1 m in front of the eye: x to the right, y up. */
function writeScreenPoint(out: Float64Array, { worldFromRay: ray }: Pointer, { worldFromView: view }: ViewFrame): void {
  const depth = along(view, 8, ray);
  out[0] = -along(view, 0, ray) / depth;
  out[1] = -along(view, 4, ray) / depth;
  out[2] = 0;
}

function along(view: ArrayLike<number>, column: number, ray: ArrayLike<number>): number {
  return (view[column] ?? 0) * (ray[8] ?? 0) + (view[column + 1] ?? 0) * (ray[9] ?? 0) + (view[column + 2] ?? 0) * (ray[10] ?? 0);
}

function writeHandPoint(out: Float64Array, { worldFromGrip, worldFromRay }: Pointer): void {
  const pose = worldFromGrip ?? worldFromRay;
  for (let i = 0; i < 3; i++) out[i] = pose[12 + i] ?? 0;
}
