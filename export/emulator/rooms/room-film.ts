import type { SessionFileLight, SessionFileSurface } from '../../runtime/sessions/session-format.ts';
import { createDepthCamera } from '../depth/depth-camera.ts';
import { depthUvFromViewUv } from '../depth/depth-transform.ts';
import { createRoomView } from '../display/room-view.ts';
import { measureLight } from '../light/room-light.ts';
import type { Room } from './room.ts';

/** A camera that films a room for a recorded session. Color and depth have the same projection. */
export interface FilmCamera {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly depthWidthPx: number;
  readonly depthHeightPx: number;
  /** Column-major 4×4. */
  readonly clipFromView: ArrayLike<number>;
  readonly jpegQuality: number;
  /** Images are drawn larger by this factor and scaled down, for better quality. */
  readonly oversampling: number;
}

export interface FilmedFrame {
  readonly jpeg: Uint8Array<ArrayBuffer>;
  /** Meters, rows from the top, 0 for nothing. Each frame has the same array. */
  readonly meters: Float32Array;
}

export interface RoomFilm {
  /** The room as seen from a pose, column-major 4×4. */
  shoot(worldFromCamera: ArrayLike<number>): Promise<FilmedFrame>;
  dispose(): void;
}

/**
 * Films a room on a canvas of its own. `dispose` frees the canvas, not the room.
 *
 * @throws Error if the browser has no 2D canvas outside of a document.
 * @example
 * const film = createRoomFilm(room, camera);
 * const { jpeg, meters } = await film.shoot(worldFromCamera);
 * film.dispose();
 */
export function createRoomFilm(room: Room, camera: FilmCamera): RoomFilm {
  const view = createRoomView(room, true);
  view.resize(camera.widthPx * camera.oversampling, camera.heightPx * camera.oversampling);
  const depth = createDepthCamera(view, camera.depthWidthPx, camera.depthHeightPx, depthUvFromViewUv({}));
  const image = new OffscreenCanvas(camera.widthPx, camera.heightPx);
  const context = image.getContext('2d');
  if (!context) throw new Error('this browser draws no pictures.');
  context.imageSmoothingQuality = 'high';
  const viewport = { x: 0, y: 0, widthPx: view.canvas.width, heightPx: view.canvas.height };
  const clipFromView = new Float32Array(camera.clipFromView);
  return {
    shoot: async (worldFromCamera) => {
      const worldFromView = new Float32Array(worldFromCamera);
      view.aimRoom([{ name: 'none', clipFromView, worldFromView, viewport }]);
      context.drawImage(view.image(), 0, 0, camera.widthPx, camera.heightPx);
      const jpeg = await image.convertToBlob({ type: 'image/jpeg', quality: camera.jpegQuality });
      const meters = depth.measure({ worldFromDepth: worldFromView, clipFromDepth: clipFromView });
      return { jpeg: new Uint8Array(await jpeg.arrayBuffer()), meters };
    },
    dispose: () => {
      depth.dispose();
      view.dispose();
    },
  };
}

/**
 * What a device would estimate of the room's light, and the planes that it would detect.
 *
 * @example
 * const { light, surfaces } = surveyRoom(room);
 */
export function surveyRoom(room: Room): { readonly light: SessionFileLight; readonly surfaces: readonly SessionFileSurface[] } {
  const view = createRoomView(room, false);
  const { sphericalHarmonics, directionWorld, intensity } = measureLight(view, room);
  view.dispose();
  return {
    light: { sphericalHarmonics: [...sphericalHarmonics], primaryDirectionWorld: directionWorld, primaryIntensity: intensity },
    surfaces: room.planes.map(({ label, orientation, worldFromPlane, polygonXZ }, i) => ({
      id: `${label}-${i}`,
      kind: 'plane',
      orientation,
      label,
      worldFromPlane,
      polygonXZ,
    })),
  };
}
