import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { DetectedSurfaces } from '../../../../nodes/kit/session.ts';

/**
 * How long to wait for surfaces before a capture of the room is started, seconds. Devices that know the room report its surfaces sooner.
 */
const WAIT_S = 5;

/** Asks the device to scan the room if it knows no surface of it. */
export interface RoomCapture {
  /** Called once per frame: starts the capture if no surface was reported in time. */
  update(timeS: number, surfaces: DetectedSurfaces): void;
}

/**
 * Creates the control that starts a capture of the room, or null if the session has none (WebXR Plane Detection §4). A start makes the
 * device ask the visitor. A page can start only once per session, so a refusal is final.
 */
export function createRoomCapture(session: XRSession, capabilities: ReadonlySet<Capability>): RoomCapture | null {
  if (!capabilities.has('planes') || typeof session.initiateRoomCapture !== 'function') return null;
  let done = false;
  return {
    update: (timeS, { planes, meshes }) => {
      if (done) return;
      const knowsRoom = planes.length > 0 || meshes.length > 0;
      if (!knowsRoom && timeS < WAIT_S) return;
      done = true;
      if (!knowsRoom) session.initiateRoomCapture?.().catch(() => {});
    },
  };
}
