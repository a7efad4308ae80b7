import type { Pointer, PointerKind, SessionInput } from './session.ts';

/**
 * Claims a pointer for a node, so that no other node handles the same press. A claim is granted in the phase `start`: to what is nearest
 * on the ray, and of several at the same distance to the first node that asks. It lasts until the frame after `end` or `cancel`. The page's
 * own use of the pointer, such as turning an orbit camera, stops. A nearer claim in the same frame replaces a farther one, so a node that
 * claims with a distance compares `pointer.owner` in the next frame before it acts.
 *
 * @param pointer A pointer of this frame.
 * @param owner Any object of the node; the node's context serves.
 * @param distanceM How far along the ray that is for which the node claims it. Default: 0, which no later claim replaces.
 * @returns Whether the pointer is the owner's, also from an earlier claim.
 *
 * @example
 * if (pointer.phase === 'start' && isOnMyObject(pointer) && claimPointer(pointer, ctx)) dragged = pointer.id;
 */
export function claimPointer(pointer: Pointer, owner: object, distanceM = 0): boolean {
  if (pointer.phase === 'start' && (pointer.owner === null || distanceM < pointer.ownerDistanceM)) {
    pointer.owner = owner;
    pointer.ownerDistanceM = distanceM;
  }
  return pointer.owner === owner;
}

/**
 * The pointer with that id in this frame.
 *
 * @returns Null where it is gone.
 *
 * @example
 * const pointer = pointerById(frame.input, dragged);
 */
export function pointerById(input: SessionInput, id: number): Pointer | null {
  for (let i = 0; i < input.pointerCount; i++) {
    const pointer = input.pointers[i];
    if (pointer?.id === id) return pointer;
  }
  return null;
}

/**
 * The hand that holds the pointer: `left` or `right` for controllers and bare hands, null for screens, mouse and gaze.
 *
 * @example
 * const controller = handOf(pointer.by) === 'left' ? input.left : input.right;
 */
export function handOf(by: PointerKind): 'left' | 'right' | null {
  switch (by) {
    case 'left':
    case 'left-hand':
      return 'left';
    case 'right':
    case 'right-hand':
      return 'right';
    case 'screen':
    case 'mouse':
    case 'gaze':
      return null;
  }
}

/**
 * How far a ray has turned. A press that turns little is a tap: WebXR selects at the end of drags too.
 *
 * @param worldFromA, worldFromB Column-major 4×4, rigid: rays along their -z axes.
 * @returns The angle between the rays, radians.
 *
 * @example
 * const isTap = pointer.tapped && rayTurnRad(startRay, pointer.worldFromRay) <= TAP_TURN_RAD;
 */
export function rayTurnRad(worldFromA: ArrayLike<number>, worldFromB: ArrayLike<number>): number {
  const ax = worldFromA[8] ?? 0;
  const ay = worldFromA[9] ?? 0;
  const az = worldFromA[10] ?? 0;
  const bx = worldFromB[8] ?? 0;
  const by = worldFromB[9] ?? 0;
  const bz = worldFromB[10] ?? 0;
  const cross = Math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx);
  return Math.atan2(cross, ax * bx + ay * by + az * bz);
}

/** A press whose ray turns more is a drag: 3°, which is 18 px on a screen of 360 px and 60°. */
export const TAP_TURN_RAD = (3 * Math.PI) / 180;

/**
 * Takes the keys for a node, as when its object is touched. Until `freeKeys`, or until another node takes them, the frames list keys
 * (`SessionInput.keys`) and the page's own use of keys, such as turning the view, stops.
 *
 * @param owner Any object of the node; the node's context serves.
 *
 * @example
 * if (claimPointer(pointer, ctx)) ownKeys(frame.input, ctx);
 */
export function ownKeys(input: SessionInput, owner: object): void {
  input.keyOwner = owner;
}

/**
 * Gives the keys back to the page, if they are the node's.
 *
 * @example
 * dispose: () => freeKeys(ctx.session.frame.input, ctx),
 */
export function freeKeys(input: SessionInput, owner: object): void {
  if (input.keyOwner === owner) input.keyOwner = null;
}
