import { type PointerSpan, writePointerSpan } from '../../kit/pointer-span.ts';
import type { Pointer, ViewFrame } from '../../kit/session.ts';

/**
 * How two pointers have moved relative to each other since both were pressed: the ratio of their distances, and the angle by which the line
 * between them has turned.
 */
export interface SpanMotion {
  scale: number;
  twistRad: number;
  begin(): void;
  /**
   * Measures the movement in this frame.
   *
   * @param pinchFrom, twistFromRad Thresholds: smaller changes do not count.
   */
  update(a: Pointer, b: Pointer, view: ViewFrame, pinchFrom: number, twistFromRad: number): void;
}

export function createSpanMotion(): SpanMotion {
  const last: PointerSpan = { lengthM: 0, angleRad: 0 };
  const now: PointerSpan = { lengthM: 0, angleRad: 0 };
  let hasLast = false;
  /** The total since the start, until the threshold is passed; then the total since that moment. */
  let scale = 1;
  let twistRad = 0;
  let scales = false;
  let twists = false;
  const motion: SpanMotion = {
    scale: 1,
    twistRad: 0,
    begin: () => {
      hasLast = false;
      scale = 1;
      twistRad = 0;
      scales = false;
      twists = false;
      motion.scale = 1;
      motion.twistRad = 0;
    },
    update: (a, b, view, pinchFrom, twistFromRad) => {
      if (!writePointerSpan(now, a, b, view)) return;
      if (hasLast) {
        scale *= now.lengthM / last.lengthM;
        const turnedRad = now.angleRad - last.angleRad;
        twistRad += Math.atan2(Math.sin(turnedRad), Math.cos(turnedRad));
      }
      hasLast = true;
      last.lengthM = now.lengthM;
      last.angleRad = now.angleRad;
      // From the threshold on, so that nothing jumps.
      if (!scales && Math.abs(Math.log(scale)) > Math.log1p(pinchFrom)) {
        scales = true;
        scale = 1;
      }
      if (!twists && Math.abs(twistRad) > twistFromRad) {
        twists = true;
        twistRad = 0;
      }
      motion.scale = scales ? scale : 1;
      motion.twistRad = twists ? twistRad : 0;
    },
  };
  return motion;
}
