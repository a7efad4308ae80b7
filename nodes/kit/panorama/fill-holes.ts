/**
 * Fills pixels without weight from their surroundings, and divides the others by their weight: pull-push over a pyramid (Gortler 1996,
 * “The Lumigraph”, §3.4). Left and right edge are neighbors.
 *
 * @param sums Four numbers per pixel: color times weight, and weight. Afterwards color and 1.
 *
 * @example
 * const sums = Float32Array.of(1, 0.5, 0, 1, 0, 0, 0, 0);
 * fillHoles(sums, 2, 1); // both pixels are now [1, 0.5, 0, 1]
 */
export function fillHoles(sums: Float32Array, widthPx: number, heightPx: number): void {
  for (let i = 0; i < sums.length; i += 4) {
    const weight = sums[i + 3] ?? 0;
    for (let c = 0; c < 3; c++) sums[i + c] = weight > 0 ? (sums[i + c] ?? 0) / weight : 0;
    sums[i + 3] = weight > 0 ? 1 : 0;
  }
  fillFromCoarser(sums, widthPx, heightPx);
}

/**
 * Fills the holes of one level of the pyramid from the next coarser level, which it computes. Colors are multiplied by their weight, from 0
 * to 1.
 */
function fillFromCoarser(fine: Float32Array, widthPx: number, heightPx: number): void {
  if (widthPx <= 1 && heightPx <= 1) return;
  const [coarseWidth, coarseHeight] = [Math.ceil(widthPx / 2), Math.ceil(heightPx / 2)];
  const coarse = new Float32Array(coarseWidth * coarseHeight * 4);
  let holes = 0;
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) {
      const from = (y * widthPx + x) * 4;
      const to = ((y >> 1) * coarseWidth + (x >> 1)) * 4;
      for (let c = 0; c < 4; c++) coarse[to + c] = (coarse[to + c] ?? 0) + (fine[from + c] ?? 0);
      if ((fine[from + 3] ?? 0) < 1) holes++;
    }
  }
  if (holes === 0) return;
  for (let i = 0; i < coarse.length; i += 4) {
    const weight = coarse[i + 3] ?? 0;
    if (weight <= 1) continue;
    for (let c = 0; c < 4; c++) coarse[i + c] = (coarse[i + c] ?? 0) / weight;
  }
  fillFromCoarser(coarse, coarseWidth, coarseHeight);
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) addMissing(fine, (y * widthPx + x) * 4, coarse, coarseWidth, coarseHeight, x, y);
  }
}

/** Fills a pixel whose weight is less than 1 up to weight 1, from the four nearest pixels of the coarser level. */
function addMissing(fine: Float32Array, at: number, coarse: Float32Array, width: number, height: number, x: number, y: number): void {
  const missing = 1 - (fine[at + 3] ?? 0);
  if (missing <= 0) return;
  const besideX = ((x >> 1) + (x & 1 ? 1 : -1) + width) % width;
  const besideY = Math.min(Math.max((y >> 1) + (y & 1 ? 1 : -1), 0), height - 1);
  const corners = [
    [(y >> 1) * width + (x >> 1), 9 / 16],
    [(y >> 1) * width + besideX, 3 / 16],
    [besideY * width + (x >> 1), 3 / 16],
    [besideY * width + besideX, 1 / 16],
  ] as const;
  let total = 0;
  for (const [i, share] of corners) total += share * (coarse[i * 4 + 3] ?? 0);
  if (total <= 0) return;
  for (let c = 0; c < 3; c++) {
    let sum = 0;
    for (const [i, share] of corners) sum += share * (coarse[i * 4 + c] ?? 0);
    fine[at + c] = (fine[at + c] ?? 0) + (missing * sum) / total;
  }
  fine[at + 3] = 1;
}
