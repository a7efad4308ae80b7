import { setDeviceRotation, turnAboutVertical, yawToFront } from '../../../../nodes/kit/device-orientation.ts';
import type { GestureTarget } from '../orbit/orbit-input.ts';
import type { OrientationSensor } from './orientation-sensor.ts';

/** Initial position of the viewer, meters: two meters behind the origin, at eye height. */
const START = [0, 1.5, 2] as const;
/** Initial pitch without a sensor: slightly down, towards objects near the origin. */
const START_PITCH_RAD = -0.35;
/** Maximum distance from the initial position, meters. */
const REACH_M = 5;
/** Distance that zoom factors refer to, meters: a pinch by 2 moves the viewer by half of it. */
const STEP_SCALE_M = 1;
const MAX_PITCH_RAD = 1.5;
const LOWEST_M = 0.3;
const HIGHEST_M = 2.5;
/**
 * Limits of the distance from the eyes to the point of the floor that a drag follows, meters. The point is where the viewing direction
 * meets the floor.
 */
const NEAREST_FLOOR_M = 0.5;
const FARTHEST_FLOOR_M = 4;
/**
 * Angle of view of the image, approximately. Gestures count a drag over the whole image as a rotation by π; this angle converts that to an
 * angle in the image.
 */
const IMAGE_RAD = 0.9;

/**
 * A viewer who rotates with the device but has a fixed position, because no sensor measures it. Drags, wheel and keys rotate about the
 * vertical axis and move the viewer. A drag up or down sets how high the eyes are above the floor, so that objects stand on the floor of the
 * image: with one finger where the sensor tells the pitch, else with two.
 */
export interface CameraViewer extends GestureTarget {
  /** Restores the initial position and makes the current direction of the device point along −z. */
  reset(): void;
  writeWorldFromView(out: Float32Array): void;
}

export function createCameraViewer(sensor: Pick<OrientationSensor, 'angles' | 'present'>): CameraViewer {
  let yawRad = 0;
  /** Pitch of the viewer, used only without a sensor. */
  let pitchRad = START_PITCH_RAD;
  let [x, y, z] = START as readonly [number, number, number];
  /** Sine of the angle by which the view that was written last looks down. */
  let down = 0;
  let centered = false;
  /** Heading of the view written last, about the vertical axis; 0 is −z. */
  let heading = 0;
  const scratchUpright = { alphaRad: 0, betaRad: Math.PI / 2, gammaRad: 0, screenRad: 0 };

  /** Moves the viewer on the floor, relative to the heading. */
  const step = (rightM: number, aheadM: number): void => {
    const c = Math.cos(heading);
    const s = Math.sin(heading);
    x = clamp(x + rightM * c - aheadM * s, START[0] - REACH_M, START[0] + REACH_M);
    z = clamp(z - rightM * s - aheadM * c, START[2] - REACH_M, START[2] + REACH_M);
  };
  const raise = (byM: number): void => {
    y = clamp(y + byM, LOWEST_M, HIGHEST_M);
  };
  return {
    distanceM: STEP_SCALE_M,
    rotate: (azimuthRad, elevationRad) => {
      yawRad -= azimuthRad;
      // The larger part of a slanted drag counts.
      if (sensor.present && Math.abs(elevationRad) > Math.abs(azimuthRad)) {
        const floorM = clamp(y / Math.max(down, 0.01), NEAREST_FLOOR_M, FARTHEST_FLOOR_M);
        raise((elevationRad / Math.PI) * IMAGE_RAD * floorM);
      }
      pitchRad = clamp(pitchRad + elevationRad, -MAX_PITCH_RAD, MAX_PITCH_RAD);
    },
    zoom: (factor) => step(0, Math.log(factor) * STEP_SCALE_M),
    pan: (rightM, upM) => {
      step(rightM, 0);
      raise(upM);
    },
    reset: () => {
      yawRad = 0;
      pitchRad = START_PITCH_RAD;
      [x, y, z] = START;
      centered = false;
    },
    writeWorldFromView: (out) => {
      if (sensor.present) {
        setDeviceRotation(out, sensor.angles);
        if (!centered) {
          yawRad += yawToFront(out);
          centered = true;
        }
      } else {
        scratchUpright.betaRad = Math.PI / 2 + pitchRad;
        setDeviceRotation(out, scratchUpright);
      }
      turnAboutVertical(out, yawRad);
      heading = -yawToFront(out);
      down = out[9] ?? 0;
      out[12] = x;
      out[13] = y;
      out[14] = z;
    },
  };
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}
