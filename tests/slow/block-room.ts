import { Vector3 } from 'three';
import { createRandom } from '../../export/runtime/random.ts';
import type { RoomDepth } from '../../nodes/kit/session.ts';
import { lookingAt } from '../browser/scenes-kit.ts';
import { SIDES, stand } from '../browser/shadow-kit.ts';

/** A real floor and a real block on it, as a sensor sees them. */

export const ROOM_CAMERA = lookingAt([0.1, 1.5, 1.1], [0.1, 0, 0], SIDES.widthPx / SIDES.heightPx);
/** A real block: its top is 30 cm high, over x from 0.1 to 0.7 and z from -0.5 to 0.4. */
export const BLOCK = { x0: 0.1, x1: 0.7, z0: -0.5, z1: 0.4, topM: 0.3 } as const;

/** What is seen there through a place of the view: world, and meters along the view's axis. */
export function look(u: number, v: number, block: boolean): { point: Vector3; meters: number; onBlock: boolean } {
  const eye = ROOM_CAMERA.position;
  const ray = new Vector3(u * 2 - 1, v * 2 - 1, 0.5).unproject(ROOM_CAMERA).sub(eye).normalize();
  const along = new Vector3(0, 0, -1).transformDirection(ROOM_CAMERA.matrixWorld).dot(ray);
  let best = { t: -eye.y / ray.y, onBlock: false };
  if (block) {
    let [near, far] = [0, Number.POSITIVE_INFINITY];
    for (const [from, to, at, by] of [
      [BLOCK.x0, BLOCK.x1, eye.x, ray.x],
      [0, BLOCK.topM, eye.y, ray.y],
      [BLOCK.z0, BLOCK.z1, eye.z, ray.z],
    ] as const) {
      const [a, b] = [(from - at) / by, (to - at) / by];
      near = Math.max(near, Math.min(a, b));
      far = Math.min(far, Math.max(a, b));
    }
    if (near < far && near < best.t) best = { t: near, onBlock: true };
  }
  return { point: eye.clone().addScaledVector(ray, best.t), meters: best.t * along, onBlock: best.onBlock };
}

/** As a sensor of few pixels gives it, first row on top; `noise`: what is added to so many meters. */
export function measuredRoom(widthPx: number, heightPx: number, block: boolean, noise: (meters: number) => number = () => 0): RoomDepth {
  const { gl } = stand;
  const meters = new Float32Array(widthPx * heightPx);
  for (let i = 0; i < meters.length; i++) {
    const { meters: exact } = look(((i % widthPx) + 0.5) / widthPx, 1 - (Math.floor(i / widthPx) + 0.5) / heightPx, block);
    meters[i] = exact + noise(exact);
  }
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, widthPx, heightPx, 0, gl.RED, gl.FLOAT, meters);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  return { texture, widthPx, heightPx, uvFromViewUv: Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1), worldFromDepth: new Float32Array(16) };
}

/** Of sensors: normally distributed, by Box and Muller, 1 cm and 0.5 % of the distance. */
export function sensorNoise(seed: number): (meters: number) => number {
  const { next } = createRandom(seed, 'sensor');
  return (meters) => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next()) * (0.01 + 0.005 * meters);
}
