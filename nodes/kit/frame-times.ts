/** The start times of the frames of a recording. The recording loops, so frame numbers are unlimited. */
export interface FrameTimes {
  /** Start times of the frames: seconds since the first frame, ascending; at least one element. */
  readonly timesS: readonly number[];
  /** Length of the recording, from the start of the first frame to the end of the last, seconds. */
  readonly durationS: number;
}

/** Tolerance in comparing times: more than the rounding error of summed frame times, and less than the time between any two frames. */
const ROUNDING_S = 1e-6;

/**
 * The time at which a frame begins. The recording loops, so numbers beyond its end continue in the next iteration.
 *
 * @param times The recording.
 * @param number Frame number, from 0.
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
 * The frame that is shown at a time; frame numbers continue through the iterations of the loop.
 *
 * @param times The recording.
 * @param timeS Seconds since the first frame.
 * @returns Frame number, from 0; 0 before the first frame.
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
