import type { Capability } from '../../nodes/kit/definition.ts';
import type { CreateLens } from '../runtime/sessions/camera/lens.ts';
import type { requestCameraSession } from '../runtime/sessions/camera/request-camera.ts';
import type { SessionInputs } from '../runtime/sessions/input/session-inputs.ts';
import type { requestWebXrSession } from '../runtime/sessions/webxr/request-session.ts';
import type { CreateRoomPanel } from './room-panel/room-panel.ts';
import type { OfferRoomScan } from './room-scan.ts';
import type { SessionMode } from './session-modes.ts';

/** The sessions that a visitor enters. A page of several files loads them as an own script after its first image (ADR 44). */
export interface EnteredSessions {
  readonly requestWebXr: typeof requestWebXrSession;
  /** Null if no tier of the program is played with a camera. */
  readonly requestCamera: typeof requestCameraSession | null;
  /**
   * Creates the estimation of the camera's field of view; null if the program draws no objects, because only objects must keep their place
   * in the camera image.
   */
  readonly createLens: CreateLens | null;
  /** Creates the panel with the controls in the room; null if there are no controls. */
  readonly createRoomPanel: CreateRoomPanel | null;
  /** Functions by which the panel that offers a scan reads input, if the program itself reads none; otherwise null. */
  readonly inputs: SessionInputs | null;
  /** Offers a scan of the room where the device knows none of it; null if the program reads no planes. */
  readonly offerRoomScan: OfferRoomScan | null;
  readonly texts: typeof SESSION_TEXTS;
  /** How to look around in a camera session; null if the image does not depend on the view. */
  readonly cameraHint: string | null;
}

/** What the page says about sessions. */
export const SESSION_TEXTS = {
  ended: {
    ar: 'AR has ended. You can enter it again.',
    camera: 'The camera stopped. Close other apps that use it, then try again.',
    vr: 'VR has ended. You can enter it again.',
  } as Readonly<Record<SessionMode, string>>,
  untracked: {
    ar: 'Looking for the room: move slowly, with enough light.',
    camera: 'This device has no motion sensor. Drag to look around.',
    vr: 'The headset lost tracking. Look around slowly, with enough light.',
  } as Readonly<Record<SessionMode, string>>,
  /** Notice for each feature that was granted but currently delivers no data. */
  silent: {
    depth: 'The device measures no depth at the moment, so real objects hide nothing. Move it slowly from side to side.',
    'light-estimation': 'The device does not measure the light of the room at the moment. Default light is used.',
  } as Readonly<Partial<Record<Capability, string>>>,
};

/** What the page says when a camera session begins. */
export const CAMERA_HINT = 'Turn the device to look around. Drag up or down until objects stand on the floor. Pinch or scroll to zoom.';
