export type WheelStep = Pick<WheelEvent, 'deltaX' | 'deltaY' | 'deltaMode' | 'ctrlKey' | 'timeStamp'> & {
  /** Nonstandard: ±120 per notch of a wheel, in Chromium and WebKit. */
  readonly wheelDeltaY?: number;
};

const NOTCH = 120;
/** Smallest step of a wheel, in CSS pixels. */
const WHEEL_STEP_PX = 40;
/** Events closer than this belong to one gesture, and so to one device. */
const GESTURE_MS = 150;

/**
 * Decides for each wheel event whether it comes from a trackpad. The browser does not say it: wheels send large equal steps along one
 * axis; trackpads send small ones along both, which grow large in a fast gesture. So the first event of a gesture decides.
 */
export function createWheelDevice(): { isTrackpad(step: WheelStep): boolean } {
  let lastMs = Number.NEGATIVE_INFINITY;
  let trackpad = false;
  return {
    isTrackpad: (step) => {
      const begins = step.timeStamp - lastMs > GESTURE_MS;
      lastMs = step.timeStamp;
      // Small steps are a trackpad's in any case, so a gesture that began at full speed is corrected.
      if (begins || !isWheel(step)) trackpad = !isWheel(step);
      return trackpad;
    },
  };
}

function isWheel({ deltaX, deltaY, deltaMode, wheelDeltaY = 0 }: WheelStep): boolean {
  // Only wheels scroll by lines or pages.
  if (deltaMode !== 0) return true;
  if (deltaX !== 0 || Math.abs(deltaY) < WHEEL_STEP_PX) return false;
  // The page's zoom and the pixel ratio make steps of a wheel fractions. Trackpads report three times their pixels as `wheelDelta`.
  return Number.isInteger(deltaY) || (wheelDeltaY !== 0 && wheelDeltaY % NOTCH === 0);
}

/** Pixels of a line and of a page in wheel events, as in d3-zoom. */
const UNIT_PX = [1, 25, 500];
const DOUBLING_PX = 500;
/** A pinch moves far fewer pixels than a wheel for the same zoom. */
const PINCH = 10;

/**
 * Factor by which a wheel event with Ctrl zooms: a pinch, which browsers report so, or a turn of the wheel. The same on all systems.
 * The factors of one event stay within 1/2 and 2.
 */
export function zoomFactor({ deltaX, deltaY, deltaMode, ...rest }: WheelStep): number {
  const isPinch = !isWheel({ deltaX, deltaY, deltaMode, ...rest });
  const doublings = (-deltaY * (UNIT_PX[deltaMode] ?? 1) * (isPinch ? PINCH : 1)) / DOUBLING_PX;
  return 2 ** Math.min(Math.max(doublings, -1), 1);
}
