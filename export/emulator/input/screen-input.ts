import type { XRFrame, XRReferenceSpace, XRSession } from 'iwer';
import { P_SPACE, XRInputSource, XRInputSourceEvent, XRSpace } from 'iwer';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { writeMatrix } from '../session/rigid-transform.ts';

/**
 * A finger on the screen of a handheld device: a transient input source of target ray mode `screen` (WebXR Device API §12.1), present from
 * touch to release.
 */
export interface ScreenInput {
  /** Normalized, origin at the top left of the view. A silent press dispatches no select events, because an overlay canceled it. */
  press(x: number, y: number, silent?: boolean): void;
  move(x: number, y: number): void;
  release(): void;
  sources(): readonly XRInputSource[];
  /** Dispatches the events since the last frame. `refresh` makes the session update its input sources. */
  fire(frame: XRFrame, session: XRSession, refresh: () => void): void;
  /** Sets the target ray through the touched point, from the poses of this frame. */
  aim(clipFromView: Float32Array): void;
  reset(): void;
}

type Phase = 'up' | 'pressed' | 'down';

export function createScreenInput(viewerSpace: XRReferenceSpace): ScreenInput {
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
    press: (x, y, silent = false) => {
      if (phase !== 'up') throw new Error('The screen is already touched. Release it first.');
      point = { x, y };
      phase = 'pressed';
      released = false;
      silenced = silent;
    },
    move: (x, y) => {
      point = { x, y };
    },
    release: () => {
      if (phase === 'up') throw new Error('The screen is not touched. Press it first.');
      released = true;
    },
    sources: () => (phase === 'down' ? [source] : []),
    fire: (frame, session, refresh) => {
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
    aim: (clipFromView) => writeMatrix(space[P_SPACE].offsetMatrix, viewerFromRay(clipFromView, point.x, point.y)),
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
