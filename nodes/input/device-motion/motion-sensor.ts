import { screenAngle } from '../../kit/device-orientation.ts';
import type { ShakeDetector } from './shake.ts';

/** The newest readings of the motion sensors of a device, along the axes of the screen: x right, y up, z towards the visitor. */
export interface MotionSensor {
  readonly present: boolean;
  /** Acceleration without gravity, m/s². */
  readonly acceleration: Float64Array;
  /** Angular velocity about each axis of the screen: radians per second, counterclockwise seen from the tip of the axis. */
  readonly rotationRate: Float64Array;
  /** Unit vector that points away from the ground. */
  readonly up: Float64Array;
  dispose(): void;
}

interface Axes {
  readonly x: number | null;
  readonly y: number | null;
  readonly z: number | null;
}

const RAD_PER_DEG = Math.PI / 180;
/**
 * Weight of a new reading in the running mean of accelerations, which stands for gravity on devices that do not report gravity separately.
 * The mean follows in about half a second at 60 Hz.
 */
const GRAVITY_SHARE = 0.03;

/**
 * Listens to the events `devicemotion` and `deviceorientation`. iPhones report accelerations with the opposite sign. The sign of a device
 * is found by comparing the measured gravity with the orientation.
 */
export function listenForMotion(shake: ShakeDetector): MotionSensor {
  const acceleration = new Float64Array(3);
  const rotationRate = new Float64Array(3);
  const up = Float64Array.of(0, 1, 0);
  /** `up` in the axes of the device, which do not rotate with the page. */
  const deviceUp = Float64Array.of(0, 1, 0);
  const gravity = new Float64Array(3);
  const scratch = new Float64Array(3);
  let present = false;
  let hasOrientation = false;
  let hasGravity = false;

  /** Converts a vector from the axes of the device to the axes of the screen. */
  function toScreen(out: Float64Array, x: number, y: number, z: number): void {
    const angle = screenAngle(window);
    const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
    out[0] = cosine * x - sine * y;
    out[1] = sine * x + cosine * y;
    out[2] = z;
  }
  function orient({ beta, gamma }: DeviceOrientationEvent): void {
    if (beta === null || gamma === null) return;
    const [b, g] = [beta * RAD_PER_DEG, gamma * RAD_PER_DEG];
    deviceUp.set([-Math.cos(b) * Math.sin(g), Math.sin(b), Math.cos(b) * Math.cos(g)]);
    toScreen(up, deviceUp[0] ?? 0, deviceUp[1] ?? 0, deviceUp[2] ?? 0);
    hasOrientation = true;
    present = true;
  }
  /** Whether the device reports accelerations with the standard sign (1) or with the opposite sign (-1). */
  function signOf(total: Axes): 1 | -1 {
    if (!hasOrientation) return 1;
    return (total.x ?? 0) * (deviceUp[0] ?? 0) + (total.y ?? 0) * (deviceUp[1] ?? 0) + (total.z ?? 0) * (deviceUp[2] ?? 0) < 0 ? -1 : 1;
  }
  function followGravity(total: Axes): void {
    const share = hasGravity ? GRAVITY_SHARE : 1;
    hasGravity = true;
    [total.x, total.y, total.z].forEach((value, i) => {
      gravity[i] = (gravity[i] ?? 0) + ((value ?? 0) - (gravity[i] ?? 0)) * share;
    });
    const length = Math.hypot(...gravity);
    if (hasOrientation || length < 1) return;
    toScreen(up, (gravity[0] ?? 0) / length, (gravity[1] ?? 0) / length, (gravity[2] ?? 0) / length);
  }
  function move(event: DeviceMotionEvent): void {
    const { accelerationIncludingGravity: total, acceleration: own, rotationRate: rate } = event;
    let sign: 1 | -1 = 1;
    if (total && total.x !== null) {
      sign = signOf(total);
      followGravity(total);
      present = true;
    }
    if (own && own.x !== null) scratch.set([own.x, own.y ?? 0, own.z ?? 0]);
    else if (total && total.x !== null)
      [total.x, total.y, total.z].forEach((value, i) => {
        scratch[i] = (value ?? 0) - (gravity[i] ?? 0);
      });
    else scratch.fill(0);
    toScreen(acceleration, sign * (scratch[0] ?? 0), sign * (scratch[1] ?? 0), sign * (scratch[2] ?? 0));
    shake.feel(acceleration, event.timeStamp / 1000);
    // About x, y and z, unlike the angles of the orientation (W3C Device Orientation, “rotationRate”).
    if (!rate || rate.alpha === null) return;
    toScreen(rotationRate, rate.alpha * RAD_PER_DEG, (rate.beta ?? 0) * RAD_PER_DEG, (rate.gamma ?? 0) * RAD_PER_DEG);
    present = true;
  }

  window.addEventListener('devicemotion', move);
  window.addEventListener('deviceorientation', orient);
  return {
    get present() {
      return present;
    },
    acceleration,
    rotationRate,
    up,
    dispose: () => {
      window.removeEventListener('devicemotion', move);
      window.removeEventListener('deviceorientation', orient);
    },
  };
}
