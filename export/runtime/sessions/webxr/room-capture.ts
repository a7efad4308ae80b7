import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { DetectedSurfaces, SessionEvent } from '../../../../nodes/kit/session.ts';

/** How long to wait for surfaces before a scan is offered, seconds. Devices that know the room report its surfaces sooner. */
const WAIT_S = 5;

type RoomUnknown = Extract<SessionEvent, { readonly kind: 'room-unknown' }>;

/** Offers a scan of the room while the device knows no surface of it. */
export interface RoomCapture {
  /** Called once per frame: offers the scan if no surface was reported in time, and withdraws the offer when one is. */
  update(timeS: number, surfaces: DetectedSurfaces): void;
}

/**
 * Creates the offer of a room capture, or null if the session has none (WebXR Plane Detection §4). The scan is not started without the
 * visitor, because devices leave the page for it. A session can start only one, so a refusal is final.
 *
 * @param onOffer Called with the function that starts the scan, and with null when surfaces come after that.
 */
export function createRoomCapture(
  session: XRSession,
  capabilities: ReadonlySet<Capability>,
  onOffer: (capture: RoomUnknown['capture']) => void,
): RoomCapture | null {
  if (!capabilities.has('planes') || typeof session.initiateRoomCapture !== 'function') return null;
  let state: 'waiting' | 'offered' | 'done' = 'waiting';
  const capture = async (): Promise<boolean> => {
    if (state !== 'offered') return false;
    state = 'done';
    try {
      await session.initiateRoomCapture?.();
      return true;
    } catch {
      return false;
    }
  };
  return {
    update: (timeS, { planes, meshes }) => {
      if (state === 'done') return;
      if (planes.length > 0 || meshes.length > 0) {
        if (state === 'offered') onOffer(null);
        state = 'done';
      } else if (state === 'waiting' && timeS >= WAIT_S) {
        state = 'offered';
        onOffer(capture);
      }
    },
  };
}
