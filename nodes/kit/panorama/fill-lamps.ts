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
  const { widthPx, heightPx } = target;
  const step = Math.ceil(widthPx / size.widthPx);
  const isLamp = (x: number, y: number): boolean => inside[Math.floor(y / step) * size.widthPx + Math.floor(x / step)] !== 0;
  // Read before anything is written: only pixels outside lamps are read.
  for (let k = 0; k < runs.length; k += 3) {
    const [row = 0, first = 0, end = 0] = runs.slice(k, k + 3);
    for (let y = row * step; y < Math.min((row + 1) * step, heightPx); y++) {
      for (let x = first * step; x < Math.min(end * step, widthPx); x++) fillPixel(target, isLamp, x, y);
    }
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

const WAYS = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;

// Valid within one call.
const scratchSum = new Float64Array(3);

function fillPixel(target: FillTarget, isLamp: (x: number, y: number) => boolean, x: number, y: number): void {
  const { widthPx, heightPx } = target;
  scratchSum.fill(0);
  let weights = 0;
  for (const [dx, dy] of WAYS) {
    for (let far = 1; far < widthPx; far++) {
      const at = (x + dx * far + widthPx * far) % widthPx;
      const row = y + dy * far;
      if (row < 0 || row >= heightPx) break;
      if (isLamp(at, row)) continue;
      for (let c = 0; c < 3; c++) scratchSum[c] = (scratchSum[c] ?? 0) + target.get(at, row, c) / far;
      weights += 1 / far;
      break;
    }
  }
  for (let c = 0; c < 3; c++) target.set(x, y, c, weights > 0 ? (scratchSum[c] ?? 0) / weights : 0);
}
