import { clockwiseTurn, type DeviceAngles, screenAngle, setDeviceRotation } from '../../kit/device-orientation.ts';

/** The azimuth of the device, read from its magnetic compass. */
export interface Compass {
  /** Whether there is a reading that has not been taken yet. */
  readonly isFresh: boolean;
  /** Standard deviation of the reading. */
  readonly sigmaRad: number;
  /**
   * Takes the reading, so that `isFresh` is false until the next one.
   *
   * @param worldFromView Of this frame, column-major 4×4.
   * @returns Azimuth of world space's -z axis against magnetic north, clockwise.
   */
  take(worldFromView: ArrayLike<number>): number;
  dispose(): void;
}

/** The properties that Safari adds to the event, in degrees. */
type SafariEvent = DeviceOrientationEvent & { readonly webkitCompassHeading?: number; readonly webkitCompassAccuracy?: number };

const RAD_PER_DEG = Math.PI / 180;
/** Standard deviation where the browser states no accuracy, as on Android; compasses of phones are within 20° in most places. */
const ASSUMED_SIGMA_RAD = 10 * RAD_PER_DEG;
/**
 * Least length of the horizontal part of the device's top and back, added. Below that, Safari's heading cannot be compared with the
 * orientation.
 */
const LEAST_LEVEL = 0.5;

/**
 * Listens to the absolute orientation of the device. Safari has none: it gives an orientation relative to an arbitrary start, and
 * separately a heading; the orientation is then rotated by the difference.
 */
export function listenToCompass(): Compass {
  const angles: DeviceAngles = { alphaRad: 0, betaRad: 0, gammaRad: 0, screenRad: 0 };
  const earthFromDevice = new Float32Array(16);
  let isFresh = false;
  let sigmaRad = ASSUMED_SIGMA_RAD;

  function read({ alpha, beta, gamma }: DeviceOrientationEvent): boolean {
    if (alpha === null || beta === null || gamma === null) return false;
    angles.alphaRad = alpha * RAD_PER_DEG;
    angles.betaRad = beta * RAD_PER_DEG;
    angles.gammaRad = gamma * RAD_PER_DEG;
    return true;
  }
  function onAbsolute(event: DeviceOrientationEvent): void {
    if (!read(event)) return;
    sigmaRad = ASSUMED_SIGMA_RAD;
    isFresh = true;
  }
  function onRelative(event: SafariEvent): void {
    const { webkitCompassHeading: headingDeg, webkitCompassAccuracy: accuracyDeg = 10 } = event;
    if (headingDeg === undefined) {
      if (event.absolute) onAbsolute(event);
      return;
    }
    // -1: not calibrated.
    if (accuracyDeg < 0 || !read(event)) return;
    angles.screenRad = 0;
    setDeviceRotation(earthFromDevice, angles);
    // From lying to upright, the top and the back of the device together point where the heading does.
    const at = (i: number): number => (earthFromDevice[4 + i] ?? 0) - (earthFromDevice[8 + i] ?? 0);
    if (Math.hypot(at(0), at(2)) < LEAST_LEVEL) return;
    angles.alphaRad += Math.atan2(at(0), -at(2)) - headingDeg * RAD_PER_DEG;
    sigmaRad = Math.max(accuracyDeg, 1) * RAD_PER_DEG;
    isFresh = true;
  }
  const page = window as unknown as EventTarget;
  const absolute = onAbsolute as EventListener;
  const relative = onRelative as EventListener;
  page.addEventListener('deviceorientationabsolute', absolute);
  page.addEventListener('deviceorientation', relative);
  return {
    get isFresh() {
      return isFresh;
    },
    get sigmaRad() {
      return sigmaRad;
    },
    take: (worldFromView) => {
      isFresh = false;
      angles.screenRad = screenAngle(window);
      setDeviceRotation(earthFromDevice, angles);
      return clockwiseTurn(earthFromDevice, worldFromView);
    },
    dispose: () => {
      page.removeEventListener('deviceorientationabsolute', absolute);
      page.removeEventListener('deviceorientation', relative);
    },
  };
}
