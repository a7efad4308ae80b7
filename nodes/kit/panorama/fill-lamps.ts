/** How a fill reads and writes one channel of an image. */
export interface FillTarget {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Returns the linear light of a pixel in one channel; `y` is counted from the top. */
  get(x: number, y: number, channel: number): number;
  set(x: number, y: number, channel: number, value: number): void;
}

/**
 * Fills the pixels of lamps from their surroundings, so that the panorama without its lamps does not contain their light a second time.
 * Each pixel becomes the mean of the next pixels outside lamps to the left, right, top and bottom, weighted by 1 / distance. The seam of
 * the panorama is no border.
 *
 * @param runs Pixels of an image of `size`, as `[y, first x, last x + 1, …]`.
 * @param size Size of the image that `runs` refers to; that of the target may be a multiple.
 *
 * @example
 * fillLamps(target, found.runs, found);
 */
export function fillLamps(
  target: FillTarget,
  runs: readonly number[],
  size: { readonly widthPx: number; readonly heightPx: number },
): void {
  const inside = insideOf(runs, size);
  const step = Math.ceil(target.widthPx / size.widthPx);
  // Read before anything is written: only pixels outside lamps are read.
  for (let k = 0; k < runs.length; k += 3) {
    const [row = 0, first = 0, end = 0] = runs.slice(k, k + 3);
    for (let column = first; column < end; column++) fillCell(target, inside, size, step, column, row);
  }
}

function insideOf(runs: readonly number[], { widthPx, heightPx }: { readonly widthPx: number; readonly heightPx: number }): Uint8Array {
  const inside = new Uint8Array(widthPx * heightPx);
  for (let k = 0; k < runs.length; k += 3) {
    const start = (runs[k] ?? 0) * widthPx;
    inside.fill(1, start + (runs[k + 1] ?? 0), start + (runs[k + 2] ?? 0));
  }
  return inside;
}

type Size = Parameters<typeof fillLamps>[2];

// Valid within one call. Columns and rows of the next pixels outside lamps to the left, right, top and bottom of a cell; -1 for none.
const scratchNext = new Int32Array(4);
const scratchSum = new Float64Array(3);

/** Fills the pixels of the target that a pixel of a run covers. They have the same neighbors, so that large lamps take no long searches. */
function fillCell(target: FillTarget, inside: Uint8Array, size: Size, step: number, column: number, row: number): void {
  const { widthPx, heightPx } = target;
  findNext(inside, size, column, row);
  const [left = -1, right = -1, above = -1, below = -1] = scratchNext;
  const leftX = left < 0 ? -1 : Math.min((left + 1) * step, widthPx) - 1;
  const rightX = right < 0 ? -1 : right * step;
  const aboveY = above < 0 ? -1 : (above + 1) * step - 1;
  const belowY = below < 0 ? -1 : below * step;
  for (let y = row * step; y < Math.min((row + 1) * step, heightPx); y++) {
    for (let x = column * step; x < Math.min((column + 1) * step, widthPx); x++) {
      scratchSum.fill(0);
      let weights = 0;
      if (leftX >= 0) weights += add(target, leftX, y, (x - leftX + widthPx) % widthPx);
      if (rightX >= 0) weights += add(target, rightX, y, (rightX - x + widthPx) % widthPx);
      if (aboveY >= 0) weights += add(target, x, aboveY, y - aboveY);
      if (belowY >= 0) weights += add(target, x, belowY, belowY - y);
      for (let c = 0; c < 3; c++) target.set(x, y, c, weights > 0 ? (scratchSum[c] ?? 0) / weights : 0);
    }
  }
}

/** Writes `scratchNext`. Rows go around; columns end at the poles. */
function findNext(inside: Uint8Array, { widthPx, heightPx }: Size, column: number, row: number): void {
  scratchNext.fill(-1);
  for (const [i, way] of [-1, 1].entries()) {
    for (let far = 1; far < widthPx && scratchNext[i] === -1; far++) {
      const at = (column + way * far + widthPx) % widthPx;
      if (inside[row * widthPx + at] === 0) scratchNext[i] = at;
    }
    for (let at = row + way; at >= 0 && at < heightPx && scratchNext[i + 2] === -1; at += way) {
      if (inside[at * widthPx + column] === 0) scratchNext[i + 2] = at;
    }
  }
}

/** Adds a pixel to `scratchSum` and returns its weight. */
function add(target: FillTarget, x: number, y: number, far: number): number {
  for (let c = 0; c < 3; c++) scratchSum[c] = (scratchSum[c] ?? 0) + target.get(x, y, c) / far;
  return 1 / far;
}
