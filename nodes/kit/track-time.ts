export type Repeat = 'once' | 'loop' | 'mirror';

/**
 * Where in the track a time falls. `loop` begins anew at the first key whenever the last one is reached, `mirror` turns round at
 * both. Before the first key nothing has begun.
 */
export function timeInTrack(timeS: number, times: Float64Array, repeat: Repeat): number {
  const startS = times[0] ?? 0;
  const lengthS = (times[times.length - 1] ?? 0) - startS;
  if (repeat === 'once' || lengthS <= 0 || timeS <= startS) return timeS;
  const roundS = repeat === 'loop' ? lengthS : 2 * lengthS;
  const sinceS = (timeS - startS) % roundS;
  return startS + (sinceS <= lengthS ? sinceS : roundS - sinceS);
}
