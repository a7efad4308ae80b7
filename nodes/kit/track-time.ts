/** What a track does after its last keyframe; `mirror` is ping-pong. */
export type Repeat = 'once' | 'loop' | 'mirror';

/**
 * Maps a time to the time of the track. `loop` restarts at the first keyframe when the last is reached; `mirror` reverses the direction at
 * the first and at the last keyframe.
 *
 * @param timeS Seconds since the session began.
 * @param times Times of the keyframes, seconds, ascending.
 * @returns Seconds. Times before the first keyframe are unchanged.
 *
 * @example
 * timeInTrack(5, Float64Array.of(0, 2), 'loop'); // 1
 */
export function timeInTrack(timeS: number, times: Float64Array, repeat: Repeat): number {
  const startS = times[0] ?? 0;
  const lengthS = (times[times.length - 1] ?? 0) - startS;
  if (repeat === 'once' || lengthS <= 0 || timeS <= startS) return timeS;
  const roundS = repeat === 'loop' ? lengthS : 2 * lengthS;
  const sinceS = (timeS - startS) % roundS;
  return startS + (sinceS <= lengthS ? sinceS : roundS - sinceS);
}
