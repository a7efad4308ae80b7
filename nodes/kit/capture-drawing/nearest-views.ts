/** The views of a capture that are worth testing for one eye, the nearest first. */
export interface NearestViews {
  /** Indices of views; the first `count` are valid. */
  readonly views: Int32Array;
  readonly count: number;
  /**
   * Chooses the views again.
   *
   * @param eye Position in the space of the capture.
   * @param forward Unit vector.
   * @param sizeM Distance that counts as much as looking the opposite way.
   * @param excluded View that is never chosen; -1: none.
   */
  choose(eye: ArrayLike<number>, forward: ArrayLike<number>, sizeM: number, excluded?: number): void;
}

/**
 * Chooses up to `most` views by the distance of their cameras and the angle between the directions.
 *
 * @param positions x, y, z of each camera; `directions` are unit vectors.
 *
 * @example
 * const nearest = createNearestViews(capture.positions, capture.directions, 16);
 */
export function createNearestViews(positions: Float32Array, directions: Float32Array, most: number): NearestViews {
  const total = positions.length / 3;
  let count = Math.min(most, total);
  const views = new Int32Array(most);
  const costs = new Float64Array(most);
  return {
    views,
    get count() {
      return count;
    },
    choose: (eye, forward, sizeM, excluded = -1) => {
      let filled = 0;
      count = Math.min(most, excluded < 0 ? total : total - 1);
      for (let view = 0; view < total; view++) {
        if (view === excluded) continue;
        let square = 0;
        let cosine = 0;
        for (let axis = 0; axis < 3; axis++) {
          const away = (positions[3 * view + axis] ?? 0) - (eye[axis] ?? 0);
          square += away * away;
          cosine += (directions[3 * view + axis] ?? 0) * (forward[axis] ?? 0);
        }
        const cost = Math.sqrt(square) / sizeM + (1 - cosine) / 2;
        if (filled === count && cost >= (costs[count - 1] ?? 0)) continue;
        let at = Math.min(filled, count - 1);
        for (; at > 0 && (costs[at - 1] ?? 0) > cost; at--) {
          costs[at] = costs[at - 1] ?? 0;
          views[at] = views[at - 1] ?? 0;
        }
        costs[at] = cost;
        views[at] = view;
        if (filled < count) filled++;
      }
    },
  };
}
