import { decode } from 'fast-png';
import { Matrix4, PerspectiveCamera, PlaneGeometry, Vector3 } from 'three';
import type { RoomDepth } from '../../nodes/kit/session.ts';
import { pixel, room, sun } from '../browser/scenes-kit.ts';
import { SIDES, shoot, stand, thing } from '../browser/shadow-kit.ts';
import { measuredRoom, ROOM_CAMERA, sensorNoise } from './block-room.ts';

/** Of pixels whose depth is known, the part that is not wholly in shadow; and all alphas, bottom row first, as base64 to look at. */
export interface Cracks {
  readonly known: number;
  readonly part: number;
  readonly alphas: string;
  readonly error: number;
}

/** All that is seen faces the light, which comes from beside the eye, and all is in the shadow of one plate behind the eye. */
function cracksOf(depth: RoomDepth, camera: PerspectiveCamera, towards: Vector3, isKnown: (u: number, v: number) => boolean): Cracks {
  const behind = new Matrix4().lookAt(towards, new Vector3(), camera.up).setPosition(camera.position.clone().add(towards));
  const pixels = shoot(stand, {
    casters: [thing(new PlaneGeometry(60, 60), { at: behind })],
    receivers: [],
    lights: [sun([towards.x, towards.y, towards.z], { shadow: { areaM: 80, mapSizePx: 512, bias: 0, normalBiasM: 0.005 } })],
    method: 'map',
    camera,
    strength: 1,
    room: { depth: { views: [depth] }, toleranceM: { value: 0.05 } },
  });
  let [known, cracked, alphas] = [0, 0, ''];
  for (let y = 0; y < SIDES.heightPx; y++) {
    for (let x = 0; x < SIDES.widthPx; x++) {
      const alpha = pixel(pixels, x, y, SIDES.widthPx)[3] ?? 0;
      alphas += String.fromCharCode(alpha);
      if (!isKnown((x + 0.5) / SIDES.widthPx, (y + 0.5) / SIDES.heightPx)) continue;
      known++;
      if (alpha < 200) cracked++;
    }
  }
  return { known, part: cracked / known, alphas: btoa(alphas), error: stand.gl.getError() };
}

/** A floor and a block on it, whose top stands out by 30 cm and whose front meets the floor. */
export function block(columns: number, rows: number, seed: number | null): Cracks {
  const depth = measuredRoom(columns, rows, true, seed === null ? undefined : sensorNoise(seed));
  return cracksOf(depth, ROOM_CAMERA, new Vector3(-0.3, 1.2, 1), () => true);
}

/** A recorded room as a sensor of so many pixels would give it. */
export async function recorded(url: string, columns: number, rows: number, seed: number | null): Promise<Cracks> {
  const { width, height, data } = decode(await (await fetch(url)).arrayBuffer());
  const noise = seed === null ? () => 0 : sensorNoise(seed);
  const meters = Array.from({ length: columns * rows }, (_, i) => {
    const x = Math.floor((((i % columns) + 0.5) * width) / columns);
    const y = height - 1 - Math.floor(((Math.floor(i / columns) + 0.5) * height) / rows);
    const m = (data[y * width + x] ?? 0) * 0.001;
    return m > 0 ? m + noise(m) : 0;
  });
  // As the recording's camera sees it.
  const camera = new PerspectiveCamera(53.1, SIDES.widthPx / SIDES.heightPx, 0.1, 50);
  camera.updateMatrixWorld();
  return cracksOf(
    room(stand.gl, columns, rows, meters),
    camera,
    new Vector3(0, 0.5, 1),
    (u, v) => (meters[Math.floor(v * rows) * columns + Math.floor(u * columns)] ?? 0) > 0,
  );
}
