/// <reference lib="dom" />
import { createRoomFilm, type FilmCamera, surveyRoom } from '../../export/emulator/rooms/room-film.ts';
import { createStudioRoom } from '../../export/emulator/rooms/studio/create-studio-room.ts';

/** Page code that records the studio. `make-studio.ts` calls it through `globalThis.studio`. */
export interface StudioFrame {
  /** Color image: a JPEG as base64. */
  readonly jpeg: string;
  /** Depth image: 32-bit floats as base64, in meters, rows from the top, 0 for nothing. */
  readonly meters: string;
}

export async function film(camera: FilmCamera, poses: readonly (readonly number[])[]): Promise<StudioFrame[]> {
  const room = createStudioRoom();
  const filming = createRoomFilm(room, camera);
  const frames: StudioFrame[] = [];
  for (const pose of poses) {
    const { jpeg, meters } = await filming.shoot(pose);
    frames.push({ jpeg: toBase64(jpeg), meters: toBase64(new Uint8Array(meters.buffer)) });
  }
  filming.dispose();
  room.dispose();
  return frames;
}

export function survey(): ReturnType<typeof surveyRoom> {
  const room = createStudioRoom();
  const found = surveyRoom(room);
  room.dispose();
  return found;
}

function toBase64(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}
