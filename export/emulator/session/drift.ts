import type { XRSession } from 'iwer';
import { P_ANCHOR, P_REF_SPACE, P_SESSION, P_SPACE, XRReferenceSpaceType } from 'iwer';
import { Matrix4 } from 'three';
import type { Drift } from '../world.ts';
import { writeMatrix } from './rigid-transform.ts';

const scratchDrift = new Matrix4();
const scratchSpace = new Matrix4();

/**
 * Makes tracking drift: moves all reference spaces but the viewer's relative to the room, without an event. Anchors stay at the same point
 * of the room.
 *
 * @param offsetM In the room's axes, meters.
 * @param yawRad About the vertical through the room's origin.
 */
export function driftSpaces(session: XRSession, offsetM: readonly [number, number, number], yawRad: number): void {
  scratchDrift.makeRotationY(yawRad).setPosition(...offsetM);
  for (const space of session[P_SESSION].referenceSpaces) {
    const { type } = space[P_REF_SPACE];
    // Offset spaces follow the space that they were made from.
    if (type === XRReferenceSpaceType.Viewer) continue;
    scratchSpace.fromArray(Array.from(space[P_SPACE].offsetMatrix)).premultiply(scratchDrift);
    writeMatrix(space[P_SPACE].offsetMatrix, scratchSpace.elements);
  }
}

/** Applies the share of a steady drift (given per minute) for the time since the last frame. */
export function driftSteadily(session: XRSession, { offsetM: [x, y, z], yawRad }: Drift, deltaS: number): void {
  if (deltaS <= 0 || (x === 0 && y === 0 && z === 0 && yawRad === 0)) return;
  const share = deltaS / 60;
  driftSpaces(session, [x * share, y * share, z * share], yawRad * share);
}

/** Deletes all anchors of the session, as the system of a device does when it forgets the room. */
export function deleteAnchors(session: XRSession): void {
  for (const anchor of [...session[P_SESSION].trackedAnchors]) if (!anchor[P_ANCHOR].deleted) anchor.delete();
}
