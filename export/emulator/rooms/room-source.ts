import { createBoxRoom, type RoomBox } from './box-room.ts';
import { createCaptureRoom } from './capture-room.ts';
import type { Room } from './room.ts';
import { createStudioRoom } from './studio/create-studio-room.ts';

/** Plain data that a room is made from. Nothing is fetched: the caller loads the JSON of a capture. */
export type RoomSource =
  /** The furnished, textured room of our own. */
  | 'studio'
  /** The content of a file of `@iwer/sem/captures`. */
  | { readonly capture: unknown }
  | { readonly boxes: readonly RoomBox[] };

/** @throws Error when a capture cannot be read. */
export function createRoom(source: RoomSource): Room {
  if (source === 'studio') return createStudioRoom();
  return 'capture' in source ? createCaptureRoom(source.capture) : createBoxRoom(source.boxes);
}
