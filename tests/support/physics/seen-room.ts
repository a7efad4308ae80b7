import { Matrix4, Vector3 } from 'three';
import type { DepthFrame, VoxelSettings } from '../../../nodes/kit/physics.ts';

export const SETTINGS: VoxelSettings = { edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 5 };
const WIDTH = 80;
const HEIGHT = 60;
/** 60° wide. */
const TAN = Math.tan(Math.PI / 6);
const RAY = [(2 * TAN) / WIDTH, 0, -TAN + TAN / WIDTH, 0, (2 * TAN) / WIDTH, (-TAN * HEIGHT) / WIDTH + TAN / WIDTH];

export type Ray = { readonly from: Vector3; readonly to: Vector3 };

/** Depth of a scene that is told by the distance along rays whose length is 1 along the axis of the view. */
export function look(eye: Vector3, target: Vector3, distance: (ray: Ray) => number, deltaS = 1 / 30): DepthFrame {
  const worldFromDepth = new Matrix4().lookAt(eye, target, new Vector3(0, 1, 0.001)).setPosition(eye);
  const turn = worldFromDepth.clone().setPosition(0, 0, 0);
  const meters = Float32Array.from({ length: WIDTH * HEIGHT }, (_, k) => {
    const i = k % WIDTH;
    const j = Math.floor(k / WIDTH);
    const to = new Vector3((RAY[0] ?? 0) * i + (RAY[2] ?? 0), (RAY[4] ?? 0) * j + (RAY[5] ?? 0), -1).applyMatrix4(turn);
    const d = distance({ from: eye, to });
    return Number.isFinite(d) ? d : 0;
  });
  return { meters, widthPx: WIDTH, heightPx: HEIGHT, worldFromDepth: worldFromDepth.elements, rayFromTexel: RAY, deltaS };
}

/** The floor at a height of 0.01 m, and a box that stands on it, if there is one. */
export const roomWith =
  (box: { readonly half: number; readonly top: number } | null) =>
  (ray: Ray): number => {
    const { from, to } = ray;
    let nearest = to.y < 0 ? (0.01 - from.y) / to.y : Number.POSITIVE_INFINITY;
    if (!box) return nearest;
    const low = new Vector3(-box.half, 0, -box.half);
    const high = new Vector3(box.half, box.top, box.half);
    let enter = 0;
    let leave = Number.POSITIVE_INFINITY;
    for (const axis of ['x', 'y', 'z'] as const) {
      const a = (low[axis] - from[axis]) / to[axis];
      const b = (high[axis] - from[axis]) / to[axis];
      enter = Math.max(enter, Math.min(a, b));
      leave = Math.min(leave, Math.max(a, b));
    }
    if (enter <= leave) nearest = Math.min(nearest, enter);
    return nearest;
  };

export const EYE = new Vector3(0.3, 1.4, 1.4);
export const CENTER = new Vector3(0, 0.2, 0);
export const BOX = { half: 0.24, top: 0.38 };

/** What the eye sees of the box on the floor, and of the floor alone. */
export const SEEN_BOX = look(EYE, CENTER, roomWith(BOX));
export const SEEN_FLOOR = look(EYE, CENTER, roomWith(null));
