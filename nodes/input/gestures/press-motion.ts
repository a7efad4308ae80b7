import { isOnScreen } from '../../kit/pointer-span.ts';
import type { Pointer, ViewFrame } from '../../kit/session.ts';

/** How far a press has moved since its start. */
export interface PressMotion {
  /**
   * Angles to the right and up, radians. For fingers on the screen they are relative to the current view; for other pointers, to the view
   * in which the press started.
   */
  readonly turnRad: Float64Array;
  /** Movement in meters, world space. */
  readonly moveM: Float64Array;
  begin(pointer: Pointer, view: ViewFrame): void;
  /**
   * Measures the movement in this frame.
   *
   * @param distanceM Distance along the ray of the point whose movement is measured. Not used for a pointer with a grip, such as a tracked
   * hand: its grip is measured.
   */
  update(pointer: Pointer, view: ViewFrame, distanceM: number): void;
}

export function createPressMotion(): PressMotion {
  const turnRad = new Float64Array(2);
  const moveM = new Float64Array(3);
  const startView = new Float32Array(16);
  const startRay = new Float32Array(16);
  const startGrip = new Float32Array(16);
  const startRad = new Float64Array(2);
  const nowRad = new Float64Array(2);
  let hasGrip = false;
  return {
    turnRad,
    moveM,
    begin: (pointer, { worldFromView }) => {
      startView.set(worldFromView);
      startRay.set(pointer.worldFromRay);
      hasGrip = pointer.worldFromGrip !== null;
      if (pointer.worldFromGrip) startGrip.set(pointer.worldFromGrip);
      writeAngles(startRad, pointer.worldFromRay, worldFromView);
      turnRad.fill(0);
      moveM.fill(0);
    },
    update: (pointer, { worldFromView }, distanceM) => {
      // A finger that rests on the screen does not drag while the device moves.
      writeAngles(nowRad, pointer.worldFromRay, isOnScreen(pointer) ? worldFromView : startView);
      turnRad[0] = wrapped((nowRad[0] ?? 0) - (startRad[0] ?? 0));
      turnRad[1] = (nowRad[1] ?? 0) - (startRad[1] ?? 0);
      const grip = hasGrip ? pointer.worldFromGrip : null;
      if (hasGrip && !grip) return;
      for (let i = 0; i < 3; i++) {
        moveM[i] = grip
          ? (grip[12 + i] ?? 0) - (startGrip[12 + i] ?? 0)
          : pointAt(pointer.worldFromRay, i, distanceM) - pointAt(startRay, i, distanceM);
      }
    },
  };
}

function pointAt(ray: ArrayLike<number>, axis: number, distanceM: number): number {
  return (ray[12 + axis] ?? 0) - (ray[8 + axis] ?? 0) * distanceM;
}

/** Writes the direction of a ray relative to a view, radians: to the right of the view's axis, and above its horizon. */
function writeAngles(out: Float64Array, ray: ArrayLike<number>, view: ArrayLike<number>): void {
  const along = (column: number): number => {
    const dot = (view[column] ?? 0) * (ray[8] ?? 0) + (view[column + 1] ?? 0) * (ray[9] ?? 0) + (view[column + 2] ?? 0) * (ray[10] ?? 0);
    return -dot;
  };
  const x = along(0);
  const ahead = -along(8);
  out[0] = Math.atan2(x, ahead);
  out[1] = Math.atan2(along(4), Math.hypot(x, ahead));
}

function wrapped(rad: number): number {
  return Math.atan2(Math.sin(rad), Math.cos(rad));
}
