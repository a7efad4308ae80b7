import type { Haptics } from '../../../../nodes/kit/session.ts';

/** The motor of a gamepad: headsets have `pulse` (Gamepad Extensions §3), browsers of computers `playEffect` (Gamepad §9). */
interface Actuator {
  pulse?(value: number, durationMs: number): Promise<unknown>;
  playEffect?(type: 'dual-rumble', effect: GamepadEffectParameters): Promise<unknown>;
}

type VibratingGamepad = Omit<Gamepad, 'hapticActuators' | 'vibrationActuator'> & {
  readonly hapticActuators?: readonly (Actuator | null)[];
  readonly vibrationActuator?: Actuator | null;
};

/** Maximum duration of one effect in browsers, seconds. */
const LONGEST_S = 5;

/**
 * Returns a function that gives the motor of a gamepad, or null if it has none. The function returns the same object as long as the motor
 * is the same.
 */
export function createHapticsCache(): (gamepad: Gamepad) => Haptics | null {
  let last: Actuator | null = null;
  let haptics: Haptics | null = null;
  return (gamepad) => {
    const { hapticActuators, vibrationActuator } = gamepad as VibratingGamepad;
    const actuator = hapticActuators?.[0] ?? vibrationActuator ?? null;
    if (actuator !== last) haptics = actuator && hapticsOf(actuator);
    last = actuator;
    return haptics;
  };
}

function hapticsOf(actuator: Actuator): Haptics {
  return {
    pulse: (strength, durationS) => {
      const value = Math.min(Math.max(strength, 0), 1);
      const durationMs = Math.min(Math.max(durationS, 0), LONGEST_S) * 1000;
      if (!(value > 0 && durationMs > 0)) return;
      void played(actuator, value, durationMs).catch(() => {});
    },
  };
}

/** Vibrates. Rejects if the browser refuses the effect, also if the browser throws synchronously. */
async function played(actuator: Actuator, value: number, durationMs: number): Promise<unknown> {
  if (actuator.pulse) return actuator.pulse(value, durationMs);
  return actuator.playEffect?.('dual-rumble', { duration: durationMs, strongMagnitude: value, weakMagnitude: value });
}
