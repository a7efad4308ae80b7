import { createRoomView } from './display/room-view.ts';
import { measureLight, type RoomLight } from './light/room-light.ts';
import { createRoom, type RoomSource } from './rooms/room-source.ts';
import type { Surroundings } from './world.ts';

export interface OwnedSurroundings extends Surroundings {
  dispose(): void;
}

/** @throws Error when the room cannot be made of its source. */
export function createSurroundings(source: RoomSource | null, antialias: boolean): OwnedSurroundings {
  const room = source === null ? null : createRoom(source);
  const view = createRoomView(room, antialias);
  let light: RoomLight | null = null;
  let lightMoves = 0;
  return {
    room,
    view,
    get lightMoves() {
      return lightMoves;
    },
    moveLight: (directionWorld) => {
      if (!room) return;
      room.moveLight(directionWorld);
      room.prepare?.(view.renderer, view.scene);
      light = null;
      lightMoves++;
    },
    light: () => {
      if (room) light ??= measureLight(view, room);
      return light;
    },
    dispose: () => {
      view.dispose();
      room?.dispose();
    },
  };
}
