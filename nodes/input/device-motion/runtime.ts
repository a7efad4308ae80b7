import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { askForSensors, type SensorAnswer } from '../../kit/sensor-permission.ts';
import type { definition } from './definition.ts';
import { listenForMotion, type MotionSensor } from './motion-sensor.ts';
import { createShakeDetector } from './shake.ts';

/**
 * Time without a reading after which the device counts as having no motion sensor. Desktop browsers support the events but send no
 * readings.
 */
const SILENT_S = 2;
const STILL = Float64Array.of(0, 0, 0);
const UPRIGHT = Float64Array.of(0, 1, 0);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs, params } = ctx;
  const acceleration = new Float64Array(3);
  const rotationRate = new Float64Array(3);
  const up = Float64Array.of(0, 1, 0);
  const tilt = new Float64Array(2);
  const shake = createShakeDetector(params.shakeMPerS2.value);
  let sensor: MotionSensor | null = null;
  let listensSinceS: number | null = null;
  let isTold = false;
  let isFresh = true;

  function tell(message: string, fix: string): void {
    if (isTold) return;
    isTold = true;
    const effect = 'Effects that react to motion behave as if the device were held still.';
    ctx.report({ code: 'SCR055', severity: 'warning', message: `${message} ${effect}`, fix });
  }
  function answered(answer: SensorAnswer): void {
    if (answer === 'granted') sensor = listenForMotion(shake);
    else if (answer === 'denied') {
      tell('The motion sensor was not allowed.', 'Close this tab, open the page again and allow it.');
    } else tell('This browser gives pages no motion sensor.', 'Open the page on a phone, over HTTPS.');
  }
  // A render has no device that is moved, and must be reproducible.
  const stop = ctx.clock.held ? null : askForSensors(answered);

  /** Moves an output towards a reading, by the smoothing of the params. */
  function follow(out: Float64Array, to: Float64Array): void {
    const { value: smoothingS } = params.smoothingS;
    const share = isFresh || smoothingS <= 0 ? 1 : 1 - Math.exp(-ctx.clock.deltaS / smoothingS);
    for (let i = 0; i < 3; i++) out[i] = (out[i] ?? 0) + ((to[i] ?? 0) - (out[i] ?? 0)) * share;
  }

  return {
    update: () => {
      shake.fromMPerS2 = params.shakeMPerS2.value;
      const present = sensor?.present ?? false;
      if (sensor && !present) {
        listensSinceS ??= ctx.clock.timeS;
        if (ctx.clock.timeS - listensSinceS > SILENT_S) tell('This device has no motion sensor.', 'Open the page on a phone.');
      }
      const read = present ? sensor : null;
      follow(acceleration, read?.acceleration ?? STILL);
      follow(rotationRate, read?.rotationRate ?? STILL);
      follow(up, read?.up ?? UPRIGHT);
      // The first reading is taken over as it is.
      isFresh = !present;
      const length = Math.hypot(...up) || 1;
      for (let i = 0; i < 3; i++) up[i] = (up[i] ?? 0) / length;
      tilt[0] = Math.asin(Math.min(1, Math.max(-1, -(up[0] ?? 0))));
      tilt[1] = Math.atan2(up[2] ?? 0, up[1] ?? 1);
      outputs.acceleration.value = acceleration;
      outputs.rotationRate.value = rotationRate;
      outputs.up.value = up;
      outputs.tilt.value = tilt;
      outputs.available.value = present;
      const strength = shake.take();
      if (strength > 0) outputs.shaken.emit().number = strength;
    },
    reset: () => {
      shake.reset();
      isFresh = true;
    },
    dispose: () => {
      stop?.();
      sensor?.dispose();
    },
  };
}
