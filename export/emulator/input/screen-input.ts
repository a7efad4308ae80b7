import type { XRFrame, XRReferenceSpace, XRSession } from 'iwer';
import { P_SPACE, XRInputSource, XRInputSourceEvent, XRSpace } from 'iwer';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { writeMatrix } from '../session/rigid-transform.ts';

/**
 * The fingers on the screen of a handheld device. Each is a transient input source of target ray mode `screen` (WebXR Device API §12.1),
 * present from touch to release.
 */
export interface ScreenInput {
  /**
   * Begins a touch. Coordinates are normalized, with the origin at the top left of the view. A silent press dispatches no select events,
   * because an overlay canceled it.
   *
   * @param finger Index, from 0 to {@link FINGERS} − 1.
   * @throws Error if this finger touches the screen already.
   */
  press(x: number, y: number, finger: number, silent?: boolean): void;
  move(x: number, y: number, finger: number): void;
  /**
   * Ends a touch.
   *
   * @throws Error if this finger does not touch the screen.
   */
  release(finger: number): void;
  sources(): readonly XRInputSource[];
  /** Dispatches the events since the last frame. `refresh` makes the session update its input sources. */
  fire(frame: XRFrame, session: XRSession, refresh: () => void): void;
  /** Sets the target rays through the touched points, from the poses of this frame. */
  aim(clipFromView: Float32Array): void;
  reset(): void;
}

/** Fingers that touch the screen at once: enough for a pinch and a twist. */
const FINGERS = 2;

export function createScreenInput(viewerSpace: XRReferenceSpace): ScreenInput {
  const fingers = Array.from({ length: FINGERS }, () => createFinger(viewerSpace));
  const fingerAt = (index: number): Finger => {
    const finger = fingers[index];
    if (!finger) throw new Error(`There is no finger ${index}: the device knows ${FINGERS}.`);
    return finger;
  };
  return {
    press: (x, y, finger, silent = false) => fingerAt(finger).press(x, y, silent),
    move: (x, y, finger) => fingerAt(finger).move(x, y),
    release: (finger) => fingerAt(finger).release(),
    sources: () => fingers.flatMap(({ sources }) => sources()),
    fire: (frame, session, refresh) => {
      for (const finger of fingers) finger.fire(frame, session, refresh);
    },
    aim: (clipFromView) => {
      for (const finger of fingers) finger.aim(clipFromView);
    },
    reset: () => {
      for (const finger of fingers) finger.reset();
    },
  };
}

type Phase = 'up' | 'pressed' | 'down';
type Finger = ReturnType<typeof createFinger>;

function createFinger(viewerSpace: XRReferenceSpace) {
  const space = new XRSpace(viewerSpace);
  const source = new XRInputSource(
    'none' as string as XRInputSource['handedness'],
    'screen' as string as XRInputSource['targetRayMode'],
    ['generic-touchscreen'],
    space,
  );
  let phase: Phase = 'up';
  let released = false;
  let silenced = false;
  let point = { x: 0.5, y: 0.5 };
  const event = (type: string, frame: XRFrame): Event => new XRInputSourceEvent(type, { frame, inputSource: source });
  return {
    press: (x: number, y: number, silent: boolean) => {
      if (phase !== 'up') throw new Error('The screen is already touched. Release it first.');
      point = { x, y };
      phase = 'pressed';
      released = false;
      silenced = silent;
    },
    move: (x: number, y: number) => {
      point = { x, y };
    },
    release: () => {
      if (phase === 'up') throw new Error('The screen is not touched. Press it first.');
      released = true;
    },
    sources: (): readonly XRInputSource[] => (phase === 'down' ? [source] : []),
    fire: (frame: XRFrame, session: XRSession, refresh: () => void) => {
      if (phase === 'pressed') {
        phase = 'down';
        refresh();
        if (!silenced) session.dispatchEvent(event('selectstart', frame));
      } else if (phase === 'down' && released) {
        if (!silenced) for (const type of ['select', 'selectend']) session.dispatchEvent(event(type, frame));
        phase = 'up';
        refresh();
      }
    },
    aim: (clipFromView: Float32Array) => writeMatrix(space[P_SPACE].offsetMatrix, viewerFromRay(clipFromView, point.x, point.y)),
    reset: () => {
      phase = 'up';
    },
  };
}

const scratchTurn = new Quaternion();
const scratchDirection = new Vector3();
const scratchMatrix = new Matrix4();
const FORWARD = new Vector3(0, 0, -1);

function viewerFromRay(clipFromView: Float32Array, x: number, y: number): readonly number[] {
  const at = (i: number): number => clipFromView[i] ?? 0;
  scratchDirection.set((2 * x - 1 + at(8)) / at(0), (1 - 2 * y + at(9)) / at(5), -1).normalize();
  return scratchMatrix.makeRotationFromQuaternion(scratchTurn.setFromUnitVectors(FORWARD, scratchDirection)).elements;
}
