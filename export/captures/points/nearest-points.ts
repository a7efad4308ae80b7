/** Finds the nearest of many points. */
export interface NearestPoints {
  /** Indices of the `count` points nearest to a position, in no order; all if there are fewer. */
  near(x: number, y: number, z: number, count: number): readonly number[];
}

/**
 * Builds a k-d tree (Bentley, “Multidimensional binary search trees used for associative searching”, 1975) without pointers: the middle of
 * each range of `order` divides it.
 *
 * @param positions x, y and z of each point.
 */
export function createNearestPoints(positions: ArrayLike<number>): NearestPoints {
  const order = Uint32Array.from({ length: Math.floor(positions.length / 3) }, (_, i) => i);
  const at = (point: number, axis: number): number => positions[3 * point + axis] ?? 0;
  /** The axis by which the middle of a range divides it. */
  const axes = new Uint8Array(order.length);
  const build = (from: number, to: number): void => {
    if (to - from < 2) return;
    const part = order.subarray(from, to);
    let [axis, widest] = [0, -1];
    for (let a = 0; a < 3; a++) {
      let [least, most] = [Infinity, -Infinity];
      for (const point of part) {
        least = Math.min(least, at(point, a));
        most = Math.max(most, at(point, a));
      }
      if (most - least > widest) [axis, widest] = [a, most - least];
    }
    part.sort((a, b) => at(a, axis) - at(b, axis));
    const middle = (from + to) >> 1;
    axes[middle] = axis;
    build(from, middle);
    build(middle + 1, to);
  };
  build(0, order.length);

  return {
    near: (x, y, z, count) => {
      const target = [x, y, z];
      const found: number[] = [];
      const squares: number[] = [];
      const search = (from: number, to: number): void => {
        if (from >= to) return;
        const middle = (from + to) >> 1;
        const point = order[middle] ?? 0;
        const square = target.reduce((sum, value, axis) => sum + (value - at(point, axis)) ** 2, 0);
        if (found.length < count || square < (squares.at(-1) ?? 0)) {
          let place = found.length;
          while (place > 0 && (squares[place - 1] ?? 0) > square) place--;
          found.splice(place, 0, point);
          squares.splice(place, 0, square);
          if (found.length > count) {
            found.pop();
            squares.pop();
          }
        }
        const axis = axes[middle] ?? 0;
        const aside = (target[axis] ?? 0) - at(point, axis);
        const halves = [
          [from, middle],
          [middle + 1, to],
        ] as const;
        const [near, far] = aside < 0 ? halves : ([halves[1], halves[0]] as const);
        search(...near);
        if (found.length < count || aside * aside < (squares.at(-1) ?? 0)) search(...far);
      };
      search(0, order.length);
      return found;
    },
  };
}
