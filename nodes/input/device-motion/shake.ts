/** Finds out that a device is shaken: moved strongly one way and back. */
export interface ShakeDetector {
  /** Accelerations below it are no shaking, m/s². */
  fromMPerS2: number;
  /** Takes an acceleration without gravity. */
  feel(acceleration: ArrayLike<number>, timeS: number): void;
  /** The strongest acceleration of a shake since the last call, m/s²; 0 for none. */
  take(): number;
  reset(): void;
}

/** Strong accelerations, each against the one before, that are a shake. */
const TURNS = 3;
/** All of them happen within it. */
const WITHIN_S = 1;
/** After a shake, a rest, so that a long shake is not many. */
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
