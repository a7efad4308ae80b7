import type { FrameTimes } from '../../nodes/kit/frame-times.ts';
import type { AnimatedParam } from '../state/params/keyframes.ts';

const LEAST_S = 5;
/** Length of the timeline as a multiple of the time of the last keyframe, so that this keyframe can be dragged further. */
const ROOM = 1.25;
const MOST_MARKS = 12;
const STEPS_S = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600];

/** Length of the timeline in seconds: that of the recording, or whole seconds if keyframes exceed it or there is no recording. */
export function lengthOf(tracks: readonly AnimatedParam[], frames: FrameTimes | null): number {
  const lastS = Math.max(0, ...tracks.map(({ track }) => track.keys.at(-1)?.timeS ?? 0));
  if (frames !== null && lastS < frames.durationS) return frames.durationS;
  return Math.max(LEAST_S, Math.ceil(lastS * ROOM));
}

/** Times of the ruler labels, in seconds. */
export function marksOf(lengthS: number): readonly number[] {
  const stepS = STEPS_S.find((step) => lengthS / step <= MOST_MARKS) ?? lengthS;
  // Rounding avoids accumulated errors: 0.1 + 0.2 is not 0.3.
  return Array.from({ length: Math.floor(lengthS / stepS + 1e-6) + 1 }, (_, i) => Math.round(i * stepS * 10) / 10);
}

export function percentOf(timeS: number, lengthS: number): string {
  return `${((timeS / lengthS) * 100).toFixed(3)}%`;
}

/** Time under the pointer in seconds; `box` spans the whole timeline. */
export function timeAt(clientX: number, { left, width }: Pick<DOMRect, 'left' | 'width'>, lengthS: number): number {
  return Math.max(0, Math.min(1, (clientX - left) / width)) * lengthS;
}
