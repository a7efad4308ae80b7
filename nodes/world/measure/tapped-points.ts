import type { AnchorService } from '../../kit/anchors.ts';
import type { Hit } from '../../kit/hit-test.ts';
import { LEAST, MOST, type Mode } from './figure.ts';
import { type PointNoise, setNoise } from './propagate.ts';
import { createSighting, followAnchor, mark, type Sighting } from './sighting.ts';

/** The points of one measurement, which taps or pulses add. */
export interface TappedPoints {
  /** The points and where they were seen from. The first `count` are set; the next one may show where a tap would add a point (`aim`). */
  readonly sightings: readonly Sighting[];
  readonly count: number;
  readonly isComplete: boolean;
  /**
   * Adds a point. At the last point of a line or the first point of an outline it completes the measurement instead. If the measurement is
   * complete already, it begins a new one.
   */
  add(at: Hit | ArrayLike<number>, eyeM: Float64Array): void;
  /** Sets `sightings[count]` to where a tap would add the next point. Returns false if no further point can be added. */
  aim(at: Hit, eyeM: Float64Array, noise: PointNoise): boolean;
  undo(): void;
  finish(): void;
  clear(): void;
  /** Moves the points with their anchors. Call it once per frame. */
  follow(noise: PointNoise): void;
}

/** A tap whose direction differs from that of a point by less than this angle is at that point. */
const SAME_RAD = (1.5 * Math.PI) / 180;

export function createTappedPoints(mode: Mode, anchors: () => AnchorService): TappedPoints {
  const sightings = Array.from({ length: MOST[mode] }, createSighting);
  let count = 0;
  let isComplete = false;

  function drop(from: number): void {
    for (let i = from; i < count; i++) {
      const sighting = sightings[i];
      sighting?.anchor?.delete();
      if (sighting) sighting.anchor = null;
    }
    count = Math.min(count, from);
    isComplete = false;
  }
  /** Whether a tap ends the measurement: it is at the last point of a line, or at the first point of an outline. */
  function isAtEnd(at: Hit | ArrayLike<number>, eyeM: Float64Array): boolean {
    if (count < LEAST[mode] || (mode !== 'polyline' && mode !== 'polygon')) return false;
    const end = sightings[mode === 'polygon' ? 0 : count - 1]?.point.positionM;
    const matrix = 'worldFromHit' in at ? at.worldFromHit : at;
    if (!end) return false;
    let apart = 0;
    let away = 0;
    for (let i = 0; i < 3; i++) {
      apart += ((matrix[12 + i] ?? 0) - (end[i] ?? 0)) ** 2;
      away += ((end[i] ?? 0) - (eyeM[i] ?? 0)) ** 2;
    }
    return apart <= SAME_RAD ** 2 * away;
  }

  return {
    sightings,
    get count() {
      return count;
    },
    get isComplete() {
      return isComplete;
    },
    add: (at, eyeM) => {
      if (isComplete) drop(0);
      if (isAtEnd(at, eyeM)) {
        isComplete = true;
        return;
      }
      const next = sightings[count];
      if (!next) return;
      mark(next, at, eyeM, anchors());
      count++;
      isComplete = count === MOST[mode];
    },
    aim: (at, eyeM, noise) => {
      const next = isComplete || count === 0 ? undefined : sightings[count];
      if (!next) return false;
      for (let i = 0; i < 3; i++) next.seenAtM[i] = at.worldFromHit[12 + i] ?? 0;
      next.point.positionM.set(next.seenAtM);
      next.eyeM.set(eyeM);
      setNoise(next.point, next.eyeM, noise);
      return true;
    },
    undo: () => drop(Math.max(0, count - 1)),
    finish: () => {
      if (count >= LEAST[mode]) isComplete = true;
    },
    clear: () => drop(0),
    follow: (noise) => {
      for (let i = 0; i < count; i++) {
        const sighting = sightings[i];
        if (sighting) followAnchor(sighting, noise);
      }
    },
  };
}
