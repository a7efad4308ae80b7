/** Detects that a device is shaken: accelerated strongly in alternating directions. */
export interface ShakeDetector {
  /** Threshold, m/s²: weaker accelerations are no part of a shake. */
  fromMPerS2: number;
  /** Passes the next reading to the detector: an acceleration without gravity, m/s². */
  feel(acceleration: ArrayLike<number>, timeS: number): void;
  /** Returns the strongest acceleration of a shake that was detected since the last call, m/s²; 0 if there was none. */
  take(): number;
  reset(): void;
}

/** How many strong accelerations make a shake. Each must be opposite to the one before. */
const TURNS = 3;
/** The longest time that the accelerations of one shake may take. */
const WITHIN_S = 1;
/** Time after a shake in which no other is detected, so that a long shake counts once. */
const REST_S = 0.6;

export function createShakeDetector(fromMPerS2: number): ShakeDetector {
  const last = new Float64Array(3);
  let turns = 0;
  let beganS = 0;
  let restsUntilS = Number.NEGATIVE_INFINITY;
  let strongest = 0;
  let shaken = 0;
  const detector: ShakeDetector = {
    fromMPerS2,
    feel: (acceleration, timeS) => {
      const strength = Math.hypot(acceleration[0] ?? 0, acceleration[1] ?? 0, acceleration[2] ?? 0);
      if (!(strength >= detector.fromMPerS2) || timeS < restsUntilS) return;
      if (turns > 0 && timeS - beganS > WITHIN_S) turns = 0;
      let along = 0;
      for (let i = 0; i < 3; i++) along += (acceleration[i] ?? 0) * (last[i] ?? 0);
      if (turns > 0 && along >= 0) {
        strongest = Math.max(strongest, strength);
        return;
      }
      if (turns === 0) {
        beganS = timeS;
        strongest = 0;
      }
      turns++;
      strongest = Math.max(strongest, strength);
      for (let i = 0; i < 3; i++) last[i] = acceleration[i] ?? 0;
      if (turns < TURNS) return;
      shaken = strongest;
      turns = 0;
      restsUntilS = timeS + REST_S;
    },
    take: () => {
      const taken = shaken;
      shaken = 0;
      return taken;
    },
    reset: () => {
      turns = 0;
      shaken = 0;
      restsUntilS = Number.NEGATIVE_INFINITY;
    },
  };
  return detector;
}
