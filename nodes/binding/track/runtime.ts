import { type BindingContext, type BoundValue, createWriter } from '../../kit/binding.ts';
import { type Easing, ease, type Handles } from '../../kit/ease.ts';
import type { NodeRuntime } from '../../kit/runtime.ts';
import { type Repeat, timeInTrack } from '../../kit/track-time.ts';

interface Config {
  /** Times of the keyframes: seconds since the session began, ascending. */
  readonly times: readonly number[];
  /** The numbers of each keyframe, one keyframe after the other. */
  readonly values: readonly number[];
  /** The easing of each keyframe: a name, or control points separated by commas. */
  readonly easings: string;
  /** The param's minimum and maximum for each number. Present only if an easing overshoots, because only then can a result exceed them. */
  readonly limits?: readonly number[];
  readonly repeat: Repeat;
}

/**
 * Plays a keyframe track. Before the first keyframe the param has the value of that keyframe; `repeat` decides what follows the last one.
 */
export function create({ outputs, config: made, clock }: BindingContext): NodeRuntime {
  const config = made as unknown as Config;
  const bound = outputs.value as BoundValue;
  const times = Float64Array.from(config.times);
  const values = Float64Array.from(config.values);
  const easings = config.easings.split(' ').map(readEasing);
  const size = values.length / times.length;
  const limits = config.limits && Float64Array.from(config.limits);
  const now = new Float64Array(size);
  const write = createWriter(bound, now);
  const last = times.length - 1;
  return {
    update: () => {
      const timeS = timeInTrack(clock.timeS, times, config.repeat);
      const key = keyBefore(times, timeS);
      const next = Math.min(key + 1, last);
      const startS = times[key] ?? 0;
      const lengthS = (times[next] ?? 0) - startS;
      const progress = lengthS > 0 && timeS > startS ? ease(easings[key] ?? 'linear', (timeS - startS) / lengthS) : 0;
      for (let i = 0; i < size; i++) {
        const from = values[key * size + i] ?? 0;
        const to = values[next * size + i] ?? 0;
        // Exact at both ends, so that the value at a keyframe is that of the keyframe.
        now[i] = progress === 1 ? to : from + (to - from) * progress;
        if (limits) now[i] = Math.min(Math.max(now[i] ?? 0, limits[2 * i] ?? 0), limits[2 * i + 1] ?? 0);
      }
      write();
    },
    dispose: () => {},
  };
}

function readEasing(word: string): Easing {
  return word.includes(',') ? (word.split(',').map(Number) as unknown as Handles) : (word as Easing);
}

/** The last keyframe at or before a time, or the first. A binary search, because a track can have thousands of keyframes. */
function keyBefore(times: Float64Array, timeS: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((times[middle] ?? 0) <= timeS) low = middle;
    else high = middle - 1;
  }
  return low;
}
