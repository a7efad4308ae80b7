/** When the frames of a recording begin. After the last it begins anew, so that its frames can be counted on without end. */
export interface FrameTimes {
  /** Seconds since the first, rising; at least one. */
  readonly timesS: readonly number[];
  /** From the first to the end of the last, seconds. */
  readonly durationS: number;
}

/** Sums of frame times are off by less; no two frames are as near to each other. */
const ROUNDING_S = 1e-6;

/**
 * When a frame begins. The recording loops, so numbers beyond its end continue in the next iteration.
 *
 * @param number From 0.
 * @returns Seconds since the first frame.
 *
 * @example
 * timeOfFrame({ timesS: [0, 0.1], durationS: 0.2 }, 3); // 0.3
 */
export function timeOfFrame({ timesS, durationS }: FrameTimes, number: number): number {
  const round = Math.floor(number / timesS.length);
  return round * durationS + (timesS[number - round * timesS.length] ?? 0);
}

/**
 * The frame that is shown at a time, counted on through the iterations of the loop.
 *
 * @param timeS Seconds since the first frame.
 * @returns From 0; 0 before the first frame.
 *
 * @example
 * frameAtTime({ timesS: [0, 0.1], durationS: 0.2 }, 0.35); // 3
 */
export function frameAtTime({ timesS, durationS }: FrameTimes, timeS: number): number {
  const atS = Math.max(0, timeS) + ROUNDING_S;
  const round = Math.floor(atS / durationS);
  const withinS = atS - round * durationS;
  let low = 0;
  let high = timesS.length - 1;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if ((timesS[middle] ?? 0) <= withinS) low = middle;
    else high = middle - 1;
  }
  return round * timesS.length + low;
}
