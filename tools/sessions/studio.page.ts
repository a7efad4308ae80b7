/// <reference lib="dom" />
import { createDepthCamera } from '../../export/emulator/depth/depth-camera.ts';
import { depthUvFromViewUv } from '../../export/emulator/depth/depth-transform.ts';
import { createRoomView } from '../../export/emulator/display/room-view.ts';
import { measureLight } from '../../export/emulator/light/room-light.ts';
import { createStudioRoom } from '../../export/emulator/rooms/studio/create-studio-room.ts';
import type { SessionFileLight, SessionFileSurface } from '../../export/runtime/sessions/session-format.ts';

/** Page code that records the studio. `make-studio.ts` calls it through `globalThis.studio`. */
export interface StudioCamera {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly depthWidthPx: number;
  readonly depthHeightPx: number;
  /** Column-major 4×4, the same for color and depth. */
  readonly clipFromView: readonly number[];
  readonly jpegQuality: number;
}

export interface StudioFrame {
  /** Color image: a JPEG as base64. */
  readonly jpeg: string;
  /** Depth image: 32-bit floats as base64, in meters, rows from the top, 0 for nothing. */
  readonly meters: string;
}

/** Images are drawn larger and scaled down for better quality. */
const OVERSAMPLING = 2;

export async function film(camera: StudioCamera, poses: readonly (readonly number[])[]): Promise<StudioFrame[]> {
  const room = createStudioRoom();
  const view = createRoomView(room, true);
  view.resize(camera.widthPx * OVERSAMPLING, camera.heightPx * OVERSAMPLING);
  const depth = createDepthCamera(view, camera.depthWidthPx, camera.depthHeightPx, depthUvFromViewUv({}));
  const image = new OffscreenCanvas(camera.widthPx, camera.heightPx);
  const context = image.getContext('2d');
  if (!context) throw new Error('This browser draws no pictures.');
  context.imageSmoothingQuality = 'high';
  const frames: StudioFrame[] = [];
  for (const pose of poses) {
    const viewport = { x: 0, y: 0, widthPx: view.canvas.width, heightPx: view.canvas.height };
    const eye = {
      name: 'none',
      clipFromView: new Float32Array(camera.clipFromView),
      worldFromView: new Float32Array(pose),
      viewport,
    } as const;
    view.drawRoom([eye]);
    context.drawImage(view.canvas, 0, 0, camera.widthPx, camera.heightPx);
    const jpeg = await image.convertToBlob({ type: 'image/jpeg', quality: camera.jpegQuality });
    const meters = depth.measure({ worldFromDepth: eye.worldFromView, clipFromDepth: eye.clipFromView });
    frames.push({ jpeg: toBase64(new Uint8Array(await jpeg.arrayBuffer())), meters: toBase64(new Uint8Array(meters.buffer)) });
  }
  depth.dispose();
  view.dispose();
  room.dispose();
  return frames;
}

export function survey(): { readonly light: SessionFileLight; readonly surfaces: readonly SessionFileSurface[] } {
  const room = createStudioRoom();
  const view = createRoomView(room, false);
  const { sphericalHarmonics, directionWorld, intensity } = measureLight(view, room);
  view.dispose();
  room.dispose();
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

function toBase64(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}
