/** Half the width of the window, without its center. */
const REACH_PX = 2;
/** The smallest majority of the window's 25 pixels. */
const MAJORITY = 13;

/**
 * The median of 5 × 5 pixels of an image with the values 0 and 1, which is their majority. Pixels beyond the border repeat those at the
 * border, as in `cv::medianBlur`.
 *
 * @param image Rows from the top.
 * @returns A new image.
 *
 * @example
 * const smooth = medianOf(mask, 1024, 512);
 */
export function medianOf(image: Uint8Array, widthPx: number, heightPx: number): Uint8Array {
  const result = new Uint8Array(image.length);
  /** For each column, the number of ones in the five rows around the current one. */
  const column = new Uint8Array(widthPx);
  const rowAt = (y: number): number => Math.min(Math.max(y, 0), heightPx - 1) * widthPx;
  for (let y = -REACH_PX; y <= REACH_PX; y++) addRow(column, image, rowAt(y), 1);
  for (let y = 0; y < heightPx; y++) {
    if (y > 0) {
      addRow(column, image, rowAt(y + REACH_PX), 1);
      addRow(column, image, rowAt(y - REACH_PX - 1), -1);
    }
    const at = (x: number): number => column[Math.min(Math.max(x, 0), widthPx - 1)] ?? 0;
    let ones = at(-2) + at(-1) + at(0) + at(1) + at(2);
    for (let x = 0; x < widthPx; x++) {
      if (ones >= MAJORITY) result[y * widthPx + x] = 1;
      ones += at(x + REACH_PX + 1) - at(x - REACH_PX);
    }
  }
  return result;
}

function addRow(column: Uint8Array, image: Uint8Array, start: number, sign: number): void {
  for (let x = 0; x < column.length; x++) column[x] = (column[x] ?? 0) + sign * (image[start + x] ?? 0);
}
