/** Pose of the viewer: on a sphere around a target, looking at it. */
export interface OrbitPose {
  readonly targetWorld: readonly [number, number, number];
  readonly distanceM: number;
  /** About the vertical axis; 0 looks along −z. */
  readonly azimuthRad: number;
  /** Angle above the horizon. */
  readonly elevationRad: number;
}

/** The target is 0.75 m above the floor, near where objects usually are. */
export const ORBIT_DEFAULTS: OrbitPose = { targetWorld: [0, 0.75, 0], distanceM: 2.5, azimuthRad: 0, elevationRad: 0.25 };

const MAX_ELEVATION_RAD = 1.5;
const MIN_DISTANCE_M = 0.2;
const MAX_DISTANCE_M = 30;

export interface Orbit {
  rotate(azimuthRad: number, elevationRad: number): void;
  /** Divides the distance by `factor`. */
  zoom(factor: number): void;
  /** Moves the target along the axes of the view, meters. */
  pan(rightM: number, upM: number): void;
  reset(): void;
  readonly distanceM: number;
  writeWorldFromView(out: Float32Array): void;
}

export function createOrbit(start: OrbitPose): Orbit {
  const target = [...start.targetWorld] as [number, number, number];
  let { distanceM, azimuthRad, elevationRad } = start;
  const orbit: Orbit = {
    get distanceM() {
      return distanceM;
    },
    rotate: (azimuth, elevation) => {
      azimuthRad += azimuth;
      elevationRad = clamp(elevationRad + elevation, -MAX_ELEVATION_RAD, MAX_ELEVATION_RAD);
    },
    zoom: (factor) => {
      distanceM = clamp(distanceM / factor, MIN_DISTANCE_M, MAX_DISTANCE_M);
    },
    pan: (rightM, upM) => {
      const sinAzimuth = Math.sin(azimuthRad);
      const cosAzimuth = Math.cos(azimuthRad);
      const sinElevation = Math.sin(elevationRad);
      target[0] += rightM * cosAzimuth - upM * sinElevation * sinAzimuth;
      target[1] += upM * Math.cos(elevationRad);
      target[2] += -rightM * sinAzimuth - upM * sinElevation * cosAzimuth;
    },
    reset: () => {
      [target[0], target[1], target[2]] = start.targetWorld;
      ({ distanceM, azimuthRad, elevationRad } = start);
    },
    writeWorldFromView: (out) => {
      const sinAzimuth = Math.sin(azimuthRad);
      const cosAzimuth = Math.cos(azimuthRad);
      const sinElevation = Math.sin(elevationRad);
      const cosElevation = Math.cos(elevationRad);
      // Columns: right, up, back, position.
      out[0] = cosAzimuth;
      out[1] = 0;
      out[2] = -sinAzimuth;
      out[3] = 0;
      out[4] = -sinElevation * sinAzimuth;
      out[5] = cosElevation;
      out[6] = -sinElevation * cosAzimuth;
      out[7] = 0;
      out[8] = cosElevation * sinAzimuth;
      out[9] = sinElevation;
      out[10] = cosElevation * cosAzimuth;
      out[11] = 0;
      out[12] = target[0] + distanceM * cosElevation * sinAzimuth;
      out[13] = target[1] + distanceM * sinElevation;
      out[14] = target[2] + distanceM * cosElevation * cosAzimuth;
      out[15] = 1;
    },
  };
  return orbit;
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}
