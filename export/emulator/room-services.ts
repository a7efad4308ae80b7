import { createRoomView } from './display/room-view.ts';
import { createLayerCompositor, type LayerCompositor } from './layers/layer-compositor.ts';
import { measureLight, type RoomLight } from './light/room-light.ts';
import { createRoom, type RoomSource } from './rooms/room-source.ts';
import type { RoomServices } from './world.ts';

export interface OwnedRoomServices extends RoomServices {
  dispose(): void;
}

/**
 * Creates the room with its view and light estimation.
 *
 * @throws Error if the source is invalid.
 */
export function createRoomServices(source: RoomSource | null, antialias: boolean): OwnedRoomServices {
  const room = source === null ? null : createRoom(source);
  const view = createRoomView(room, antialias);
  let light: RoomLight | null = null;
  let lightMoves = 0;
  let compositor: LayerCompositor | null = null;
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
    compositor: () => {
      compositor ??= createLayerCompositor(view.renderer);
      return compositor;
    },
    dispose: () => {
      compositor?.dispose();
      view.dispose();
      room?.dispose();
    },
  };
}
