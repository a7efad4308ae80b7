import type { Steered } from '../orbit/orbit-input.ts';
import { setDeviceRotation, turnAboutVertical, yawToFront } from './device-pose.ts';
import type { OrientationSensor } from './orientation-sensor.ts';

/** Where one stands at first: two steps back from the origin, where things tend to be, at the height of eyes. Meters. */
const START = [0, 1.5, 2] as const;
/** Without a sensor one looks down a little, to where such things stand. */
const START_PITCH_RAD = -0.35;
/** How far one may go from there, meters. */
const REACH_M = 5;
/** What counts as near: a pinch to half of it moves on by half a meter. */
const STEP_SCALE_M = 1;
const MAX_PITCH_RAD = 1.5;

/**
 * A viewer who turns with the device and stays where they are: no sensor tells how a device moves. Fingers, wheel and keys turn
 * about the vertical, and step forth and back instead.
 */
export interface CameraStand extends Steered {
  /** The way the device points now becomes ahead, and one stands where one stood at first. */
  reset(): void;
  writeWorldFromView(out: Float32Array): void;
}

export function createCameraStand(sensor: Pick<OrientationSensor, 'angles' | 'present'>): CameraStand {
  let yawRad = 0;
  /** Only where no sensor tells. */
  let pitchRad = START_PITCH_RAD;
  let [x, , z] = START as readonly [number, number, number];
  let centered = false;
  /** Of the view written last, about the vertical; 0 looks along -z. */
  let heading = 0;
  const scratchUpright = { alphaRad: 0, betaRad: Math.PI / 2, gammaRad: 0, screenRad: 0 };

  /** On the floor, along the way one looks and across it. */
  const step = (rightM: number, aheadM: number): void => {
    const c = Math.cos(heading);
    const s = Math.sin(heading);
    x = clamp(x + rightM * c - aheadM * s, START[0] - REACH_M, START[0] + REACH_M);
    z = clamp(z - rightM * s - aheadM * c, START[2] - REACH_M, START[2] + REACH_M);
  };
  return {
    distanceM: STEP_SCALE_M,
    rotate: (azimuthRad, elevationRad) => {
      yawRad -= azimuthRad;
      pitchRad = clamp(pitchRad + elevationRad, -MAX_PITCH_RAD, MAX_PITCH_RAD);
    },
    zoom: (factor) => step(0, Math.log(factor) * STEP_SCALE_M),
    pan: (rightM) => step(rightM, 0),
    reset: () => {
      yawRad = 0;
      pitchRad = START_PITCH_RAD;
      [x, , z] = START;
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
      out[12] = x;
      out[13] = START[1];
      out[14] = z;
    },
  };
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}
