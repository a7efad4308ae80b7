import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Eye } from '../display/eye.ts';
import { projectEye } from '../session/projection.ts';

/** A depth camera beside the view, with a lens of its own: what pages get that ask for `matchDepthView: false`. */
export interface DepthSensor {
  /** Where it is in the view's space: x right, y up, z back. */
  readonly positionM?: readonly [number, number, number];
  /** How it is turned against the view: x, y, z, w. */
  readonly quaternion?: readonly [number, number, number, number];
  readonly fovYRad: number;
}

/** Where a buffer is measured from: column-major 4×4. */
export interface DepthCameraPose {
  readonly worldFromDepth: Float32Array;
  readonly clipFromDepth: Float32Array;
}

/** `aspect` is that of the sensor's upright picture; null stands for the view's own place and lens. */
export function aimSensor(sensor: DepthSensor | null, eye: Eye, aspect: number, nearM: number, farM: number): DepthCameraPose {
  if (!sensor) return { worldFromDepth: eye.worldFromView, clipFromDepth: eye.clipFromView };
  const viewFromDepth = new Matrix4().compose(
    new Vector3(...(sensor.positionM ?? [0, 0, 0])),
    new Quaternion(...(sensor.quaternion ?? [0, 0, 0, 1])).normalize(),
    new Vector3(1, 1, 1),
  );
  return {
    worldFromDepth: new Float32Array(new Matrix4().fromArray(Array.from(eye.worldFromView)).multiply(viewFromDepth).elements),
    clipFromDepth: projectEye('none', sensor.fovYRad, aspect, nearM, farM),
  };
}
