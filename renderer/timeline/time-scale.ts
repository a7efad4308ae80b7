import type { AnimatedParam } from '../state/keyframes.ts';

const LEAST_S = 5;
/** Room behind the last key, to drag it on. */
const ROOM = 1.25;
const MOST_MARKS = 12;
const STEPS_S = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600];

/** How much time the panel shows: whole seconds. */
export function lengthOf(tracks: readonly AnimatedParam[]): number {
  const lastS = Math.max(0, ...tracks.map(({ track }) => track.keys.at(-1)?.timeS ?? 0));
  return Math.max(LEAST_S, Math.ceil(lastS * ROOM));
}

/** Where the ruler says the time. */
export function marksOf(lengthS: number): readonly number[] {
  const stepS = STEPS_S.find((step) => lengthS / step <= MOST_MARKS) ?? lengthS;
  return Array.from({ length: Math.floor(lengthS / stepS) + 1 }, (_, i) => i * stepS);
}

export function percentOf(timeS: number, lengthS: number): string {
  return `${((timeS / lengthS) * 100).toFixed(3)}%`;
}
