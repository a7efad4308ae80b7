import { type CaptureAsset, PHOTO_MISSING, PHOTO_WHOLE } from '../capture-asset.ts';

/** The views of a capture that are worth testing for one eye, the nearest first. */
export interface NearestViews {
  /** Indices of views; the first `count` are valid. */
  readonly views: Int32Array;
  readonly count: number;
  /**
   * Chooses the views again, among those whose photographs are loaded, and writes `wantedView` of the capture.
   *
   * @param eye Position in the space of the capture.
   * @param forward Unit vector.
   * @param excluded View that is never chosen; -1: none.
   */
  choose(eye: ArrayLike<number>, forward: ArrayLike<number>, excluded?: number): void;
}

/** What decides about the views of a capture. */
type ChoiceOfViews = Pick<CaptureAsset, 'positions' | 'directions' | 'loaded' | 'radiusM'> & { wantedView: number };

/** A cost that is higher than any of a pose. */
const COST_PER_LOADED_FORM = 1e6;

/**
 * Chooses up to `most` views by the distance of their cameras and the angle between the directions. Half of the capture's diameter counts as
 * much as looking the opposite way.
 *
 * @example
 * const nearest = createNearestViews(capture, 16);
 */
export function createNearestViews(capture: ChoiceOfViews, most: number): NearestViews {
  const { positions, directions, loaded } = capture;
  const total = loaded.length;
  const views = new Int32Array(most);
  const costs = new Float64Array(most);
  const turns = Uint8Array.from({ length: total }, (_, view) => (directions.subarray(3 * view, 3 * view + 3).some((x) => x !== 0) ? 1 : 0));
  let count = Math.min(most, total);
  return {
    views,
    get count() {
      return count;
    },
    choose: (eye, forward, excluded = -1) => {
      let filled = 0;
      let leastWanted = Infinity;
      capture.wantedView = -1;
      for (let view = 0; view < total; view++) {
        const form = loaded[view] ?? PHOTO_WHOLE;
        if (view === excluded) continue;
        let square = 0;
        let cosine = 0;
        for (let axis = 0; axis < 3; axis++) {
          const away = (positions[3 * view + axis] ?? 0) - (eye[axis] ?? 0);
          square += away * away;
          cosine += (directions[3 * view + axis] ?? 0) * (forward[axis] ?? 0);
        }
        // A 360° view has no direction.
        const turn = turns[view] === 0 ? 0 : (1 - cosine) / 2;
        const cost = Math.sqrt(square) / capture.radiusM + turn;
        // What has no form yet comes before what has its reduced one.
        if (form !== PHOTO_WHOLE && cost + form * COST_PER_LOADED_FORM < leastWanted) {
          leastWanted = cost + form * COST_PER_LOADED_FORM;
          capture.wantedView = view;
        }
        if (form === PHOTO_MISSING || (filled === most && cost >= (costs[most - 1] ?? 0))) continue;
        let at = Math.min(filled, most - 1);
        for (; at > 0 && (costs[at - 1] ?? 0) > cost; at--) {
          costs[at] = costs[at - 1] ?? 0;
          views[at] = views[at - 1] ?? 0;
        }
        costs[at] = cost;
        views[at] = view;
        if (filled < most) filled++;
      }
      count = filled;
    },
  };
}
