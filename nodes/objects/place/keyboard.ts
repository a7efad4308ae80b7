import { Vector3 } from 'three';
import type { KeyPress, SessionFrame } from '../../kit/session.ts';
import type { ScaleLimits } from './grip.ts';
import type { Placement } from './placement.ts';

/**
 * The effect of a key on the copy that was touched last. `changed`: its placement has changed. The caller carries out the others. `leave`:
 * gives the keys back to the page.
 */
export type KeyAction = 'changed' | 'undo' | 'remove' | 'leave' | null;

const STEP_M = 0.05;
const FINE_STEP_M = 0.01;
const STEP_RAD = Math.PI / 12;
const FINE_STEP_RAD = Math.PI / 180;
const STEP_SCALE = 1.1;
const COS_45 = Math.SQRT1_2;

const UP = new Vector3(0, 1, 0);

// Filled and read within one call.
const scratchNormal = new Vector3();
const scratchAhead = new Vector3();
const scratchAcross = new Vector3();

/** The steps and limits that the node's params set. A step of 0 means the default step of the keys. */
export interface KeySteps extends ScaleLimits {
  readonly snapRad: number;
  readonly gridM: number;
}

/**
 * Applies a key: arrows move along the surface as the viewer sees it, + and − scale, Q and E rotate, Control Z undoes, Delete, Backspace
 * and X remove, Escape gives the keys back to the page. Shift makes smaller steps.
 */
export function applyKey({ key, shift, control }: KeyPress, placement: Placement, frame: SessionFrame, steps: KeySteps): KeyAction {
  if (control) return key === 'z' ? 'undo' : null;
  const stepM = steps.gridM > 0 ? steps.gridM : shift ? FINE_STEP_M : STEP_M;
  const stepRad = steps.snapRad > 0 ? steps.snapRad : shift ? FINE_STEP_RAD : STEP_RAD;
  switch (key) {
    case 'ArrowLeft':
      return move(placement, frame, -stepM, 0);
    case 'ArrowRight':
      return move(placement, frame, stepM, 0);
    case 'ArrowUp':
      return move(placement, frame, 0, stepM);
    case 'ArrowDown':
      return move(placement, frame, 0, -stepM);
    case 'q':
      placement.turnRad += stepRad;
      return 'changed';
    case 'e':
      placement.turnRad -= stepRad;
      return 'changed';
    case '+':
    case '=':
      return scale(placement, STEP_SCALE, steps);
    case '-':
    case '_':
      return scale(placement, 1 / STEP_SCALE, steps);
    case 'Delete':
    case 'Backspace':
    case 'x':
      return 'remove';
    case 'Escape':
      return 'leave';
    default:
      return null;
  }
}

function scale(placement: Placement, factor: number, { minScale, maxScale }: ScaleLimits): KeyAction {
  const before = placement.scale;
  placement.scale = Math.min(Math.max(before * factor, minScale), Math.max(minScale, maxScale));
  return placement.scale === before ? null : 'changed';
}

/** Moves along the surface. Ahead is away from the viewer on level surfaces, and up on steeper ones. */
function move(placement: Placement, { views, viewCount }: SessionFrame, acrossM: number, aheadM: number): KeyAction {
  const view = viewCount > 0 ? views[0] : undefined;
  if (!view) return null;
  scratchNormal.copy(UP).applyQuaternion(placement.rotation);
  const m = view.worldFromView;
  if (Math.abs(scratchNormal.y) < COS_45) scratchAhead.copy(UP);
  else {
    scratchAhead.set(-(m[8] ?? 0), 0, -(m[10] ?? 0));
    // Straight down: the top of the view is ahead.
    if (scratchAhead.length() < 0.1) scratchAhead.set(m[4] ?? 0, 0, m[6] ?? 0);
  }
  scratchAhead.addScaledVector(scratchNormal, -scratchAhead.dot(scratchNormal));
  if (scratchAhead.length() < 1e-6) return null;
  scratchAhead.normalize();
  scratchAcross.crossVectors(scratchAhead, scratchNormal);
  placement.positionM.addScaledVector(scratchAcross, acrossM).addScaledVector(scratchAhead, aheadM);
  placement.positionM.y = Math.max(0, placement.positionM.y);
  return 'changed';
}
