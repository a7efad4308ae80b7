import type { Pointer, PointerKind, SessionInput } from './session.ts';

/**
 * Claims a pointer for a node, so that no other node handles the same press. A claim is granted in the phase `start`, to the first
 * node in program order that asks, and lasts until the frame after `end` or `cancel`. The page's own use of the pointer, such as turning an
 * orbit camera, stops.
 *
 * @param pointer A pointer of this frame.
 * @param owner Any object of the node; the node's context serves.
 * @returns Whether the pointer is the owner's, also from an earlier claim.
 *
 * @example
 * if (pointer.phase === 'start' && isOnMyObject(pointer) && claimPointer(pointer, ctx)) dragged = pointer.id;
 */
export function claimPointer(pointer: Pointer, owner: object): boolean {
  if (pointer.phase === 'start') pointer.owner ??= owner;
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
