/// <reference lib="dom" />
import { Mesh, type ShaderMaterial } from 'three';
import type { Room } from '../../../export/emulator/rooms/room.ts';
import { createRoomFilm, type FilmCamera } from '../../../export/emulator/rooms/room-film.ts';
import { createStudioRoom } from '../../../export/emulator/rooms/studio/create-studio-room.ts';

/** Light of the image behind the window, so that it is as much brighter than the room as a day outside. */
const OUTDOORS = 7;

/** Photographs the studio from one pose with several exposures, in stops. JPEG files as bytes. */
export async function shootBracket(camera: FilmCamera, worldFromCamera: readonly number[], stops: readonly number[]): Promise<number[][]> {
  const shots: number[][] = [];
  for (const exposure of stops) {
    const room = createStudioRoom();
    expose(room, 2 ** exposure);
    const film = createRoomFilm(room, camera);
    shots.push([...(await film.shoot(worldFromCamera)).jpeg]);
    film.dispose();
    room.dispose();
  }
  return shots;
}

/** Multiplies all light of the room, which is what a longer exposure does. */
function expose(room: Room, gain: number): void {
  const shared = new Set<object>();
  room.solids.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    const baked = part.geometry.getAttribute('irradiance');
    for (let i = 0; i < baked.array.length; i++) baked.array[i] = (baked.array[i] ?? 0) * gain;
    const { glow, sun, sky } = (part.material as ShaderMaterial).uniforms;
    if (glow) glow.value *= gain * (part.name === 'outdoors' ? OUTDOORS : 1);
    for (const light of [sun, sky]) {
      if (!light || shared.has(light)) continue;
      shared.add(light);
      light.value.multiplyScalar(gain);
    }
  });
}
