import type { CaptureMesh } from '../../nodes/kit/capture.ts';

/** A signed axis of a reconstruction. */
export type Axis = '+x' | '-x' | '+y' | '-y' | '+z' | '-z';

export const AXES: readonly Axis[] = ['+x', '-x', '+y', '-y', '+z', '-z'];

/** The axis that is nearest to the mean up direction of the cameras. */
export function upAxis(poses: readonly (readonly number[])[]): Axis {
  const up = [4, 5, 6].map((i) => poses.reduce((sum, pose) => sum + (pose[i] ?? 0), 0));
  const largest = up.reduce((best, value, i) => (Math.abs(value) > Math.abs(up[best] ?? 0) ? i : best), 0);
  return AXES[2 * largest + ((up[largest] ?? 0) < 0 ? 1 : 0)] ?? '+y';
}

/** Rotations with which each axis becomes +y, row by row. */
const ROTATIONS: Readonly<Record<Axis, readonly number[]>> = {
  '+y': [1, 0, 0, 0, 1, 0, 0, 0, 1],
  '-y': [1, 0, 0, 0, -1, 0, 0, 0, -1],
  '+z': [1, 0, 0, 0, 0, 1, 0, -1, 0],
  '-z': [1, 0, 0, 0, 0, -1, 0, 1, 0],
  '+x': [0, -1, 0, 1, 0, 0, 0, 0, 1],
  '-x': [0, 1, 0, -1, 0, 0, 0, 0, 1],
};

function rotated(axis: Axis, x: number, y: number, z: number): readonly [number, number, number] {
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0] = ROTATIONS[axis];
  return [a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z];
}

/** A point after `up` has become +y. */
export function uprightPoint(up: Axis, [x, y, z]: readonly [number, number, number]): readonly [number, number, number] {
  return rotated(up, x, y, z);
}

/** Turns and scales a pose, so that `up` becomes +y, then lowers it by `floor`. The pose stays rigid: the scale moves the camera only. */
export function uprightPose(pose: readonly number[], up: Axis, scale: number, floor = 0): number[] {
  const turned = [...pose];
  for (let column = 0; column < 4; column++) {
    const [x = 0, y = 0, z = 0] = pose.slice(4 * column, 4 * column + 3);
    rotated(up, x, y, z).forEach((value, row) => {
      turned[4 * column + row] = value * (column === 3 ? scale : 1);
    });
  }
  turned[13] = (turned[13] ?? 0) - floor;
  return turned;
}

/** Turns and scales a mesh in place, then lowers it by `floor`. */
export function uprightMesh({ positions }: CaptureMesh, up: Axis, scale: number, floor = 0): void {
  for (let i = 0; i + 2 < positions.length; i += 3) {
    const [x = 0, y = 0, z = 0] = positions.subarray(i, i + 3);
    const [right, height, back] = rotated(up, x, y, z);
    positions.set([right * scale, height * scale - floor, back * scale], i);
  }
}
