import { encode } from 'fast-png';
import { createRoomFilm, type FilmCamera, surveyRoom } from '../../../export/emulator/rooms/room-film.ts';
import { createRoom } from '../../../export/emulator/rooms/room-source.ts';
import type { SessionFileFrame } from '../../../export/runtime/sessions/session-format.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import { loadRoom } from '../open-session.ts';
import { colorPath, type Film, intrinsicsOf } from './film.ts';

const METERS_PER_UNIT = 0.001;

/**
 * Films an emulated room after the recording, from the same poses, because filming in between would hold up what is recorded. Depth, light
 * and surfaces are those of the room.
 */
export function filmRoom(
  captureUrl: string | null,
  lightDirectionWorld: Extract<ToPreview, { kind: 'room-light' }>['directionWorld'],
): Film {
  return {
    take: () => true,
    make: async (frames, camera, files) => {
      const source = await loadRoom(captureUrl);
      if (source === null) throw new Error('the room could not be read.');
      const room = createRoom(source);
      room.moveLight(lightDirectionWorld);
      const film = createRoomFilm(room, camera);
      const paths: Pick<SessionFileFrame, 'color' | 'depth'>[] = [];
      try {
        for (const [i, { worldFromCamera }] of frames.entries()) {
          const [color, depth] = [colorPath(i), `depth/${String(i).padStart(6, '0')}.png`];
          const { jpeg, meters } = await film.shoot(worldFromCamera);
          files.add(color, jpeg);
          files.add(depth, encodeDepth(meters, camera));
          paths.push({ color, depth });
        }
        return { paths, head: { depth: depthOf(camera), ...surveyRoom(room) } };
      } finally {
        film.dispose();
        room.dispose();
      }
    },
  };
}

function depthOf(camera: FilmCamera) {
  const { depthWidthPx: widthPx, depthHeightPx: heightPx } = camera;
  return { widthPx, heightPx, intrinsics: intrinsicsOf(camera, widthPx, heightPx), metresPerUnit: METERS_PER_UNIT, kind: 'z' } as const;
}

function encodeDepth(meters: Float32Array, { depthWidthPx, depthHeightPx }: FilmCamera): Uint8Array {
  const data = Uint16Array.from(meters, (m) => Math.min(0xffff, Math.round(m / METERS_PER_UNIT)));
  return encode({ width: depthWidthPx, height: depthHeightPx, data, depth: 16, channels: 1 });
}
