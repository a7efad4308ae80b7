import { screenAngle } from '../../kit/device-orientation.ts';
import type { ShakeDetector } from './shake.ts';

/** Readings along the axes of the screen: x right, y up, z to the visitor. */
export interface MotionSensor {
  readonly present: boolean;
  /** Without gravity, m/s². */
  readonly acceleration: Float64Array;
  /** Radians per second, counterclockwise seen from the tip of the axis. */
  readonly rotationRate: Float64Array;
  /** Unit vector away from the ground. */
  readonly up: Float64Array;
  dispose(): void;
}

interface Axes {
  readonly x: number | null;
  readonly y: number | null;
  readonly z: number | null;
}

const RAD_PER_DEG = Math.PI / 180;
/** Share of a new reading in the mean that stands for gravity where the device does not tell it apart: about half a second at 60 Hz. */
const GRAVITY_SHARE = 0.03;

/**
 * Listens to `devicemotion` and `deviceorientation`. iPhones give accelerations with the opposite sign; which sign a device has shows in
 * gravity, whose direction the orientation tells.
 */
export function listenForMotion(shake: ShakeDetector): MotionSensor {
  const acceleration = new Float64Array(3);
  const rotationRate = new Float64Array(3);
  const up = Float64Array.of(0, 1, 0);
  /** In the axes of the device, which do not turn with the page. */
  const deviceUp = Float64Array.of(0, 1, 0);
  const gravity = new Float64Array(3);
  const scratch = new Float64Array(3);
  let present = false;
  let hasOrientation = false;
  let hasGravity = false;

  /** Writes a vector of the device along the axes of the page. */
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
  /** -1 where accelerations have the opposite sign. */
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
