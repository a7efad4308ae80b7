import type { Floor } from './find-floor.ts';
import {
  cross,
  dot,
  fromAxes,
  invertRigid,
  type Matrix,
  normalize,
  scale,
  subtract,
  transformDirection,
  transformPoint,
  type Vector,
} from './vector.ts';

/**
 * Aligns a recording to the world space of sessions: y along the normal of the floor, floor at y = 0, origin below the first camera, which
 * looks toward −z. The scale stays.
 *
 * @returns Matrix from the space of the recording to the aligned space.
 */
export function alignToFloor(floor: Floor, worldFromFirstCamera: Matrix): Matrix {
  const y = floor.normal;
  const eye = transformPoint(worldFromFirstCamera, [0, 0, 0]);
  const origin = subtract(eye, scale(y, dot(eye, y) - floor.offset));
  const back = transformDirection(worldFromFirstCamera, [0, 0, 1]);
  const level = subtract(back, scale(y, dot(back, y)));
  // A camera that looks straight down has no heading, so its x axis is used.
  const z = dot(level, level) > 1e-4 ? normalize(level) : normalize(cross(transformDirection(worldFromFirstCamera, [1, 0, 0]), y));
  return invertRigid(fromAxes(cross(y, z), y, z, origin));
}

/** Mean up vector of the cameras. */
export function meanUp(poses: readonly Matrix[]): Vector {
  const sum = poses.map((pose) => transformDirection(pose, [0, 1, 0])).reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
  return normalize(sum);
}
