import type { ViewFrame } from '../../../../nodes/kit/session.ts';

/**
 * Writes the ray from the eye through a point of the view as a rigid column-major 4×4 matrix whose −z axis points along the ray. `u` and
 * `v` are view UV with the origin at the bottom left.
 */
export function writeViewRay(out: Float32Array, view: Pick<ViewFrame, 'clipFromView' | 'worldFromView'>, u: number, v: number): void {
  const p = view.clipFromView;
  const m = view.worldFromView;
  const x = (2 * u - 1 + (p[8] ?? 0)) / (p[0] ?? 1);
  const y = (2 * v - 1 + (p[9] ?? 0)) / (p[5] ?? 1);
  const length = Math.hypot(x, y, 1);
  // Axes: back along the ray, then right (horizontal in the view), then up.
  const back = [-x / length, -y / length, 1 / length] as const;
  const level = Math.hypot(back[0], back[2]);
  const right = [back[2] / level, 0, -back[0] / level] as const;
  const up = [back[1] * right[2], back[2] * right[0] - back[0] * right[2], -back[1] * right[0]] as const;
  writeTurned(out, 0, m, right);
  writeTurned(out, 4, m, up);
  writeTurned(out, 8, m, back);
  for (let row = 0; row < 3; row++) out[12 + row] = m[12 + row] ?? 0;
  out[15] = 1;
}

function writeTurned(out: Float32Array, at: number, m: Float32Array, direction: readonly [number, number, number]): void {
  for (let row = 0; row < 3; row++) {
    out[at + row] = (m[row] ?? 0) * direction[0] + (m[row + 4] ?? 0) * direction[1] + (m[row + 8] ?? 0) * direction[2];
  }
  out[at + 3] = 0;
}
