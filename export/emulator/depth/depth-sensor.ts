import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Eye } from '../display/eye.ts';
import { projectEye } from '../session/projection.ts';

/** A depth camera with its own pose and lens, used for pages that request `matchDepthView: false`. */
export interface DepthSensor {
  /** Position in view space, meters. */
  readonly positionM?: readonly [number, number, number];
  /** Orientation in view space, as x, y, z, w. */
  readonly quaternion?: readonly [number, number, number, number];
  readonly fovYRad: number;
}

/** Pose and projection of a depth measurement, column-major 4×4. */
export interface DepthCameraPose {
  readonly worldFromDepth: Float32Array;
  readonly clipFromDepth: Float32Array;
}

/**
 * Pose and projection of a depth measurement for an eye. `aspect` is width over height of the sensor's upright image. A null sensor uses
 * the pose and lens of the view.
 */
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
