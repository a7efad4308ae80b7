import { createBoxRoom, type RoomBox } from './box-room.ts';
import { createCaptureRoom } from './capture-room.ts';
import type { Room } from './room.ts';
import { createStudioRoom } from './studio/create-studio-room.ts';

/** Plain data that describes a room. The caller loads the JSON of a capture. */
export type RoomSource =
  /** A furnished, textured room. */
  | 'studio'
  /** The content of a file of `@iwer/sem/captures`. */
  | { readonly capture: unknown }
  | { readonly boxes: readonly RoomBox[] };

/**
 * Creates a room; the caller disposes it.
 *
 * @throws Error if a capture is invalid.
 * @example
 * const room = createRoom('studio');
 * room.dispose();
 */
export function createRoom(source: RoomSource): Room {
  if (source === 'studio') return createStudioRoom();
  return 'capture' in source ? createCaptureRoom(source.capture) : createBoxRoom(source.boxes);
}
