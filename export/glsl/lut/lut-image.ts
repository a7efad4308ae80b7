import type { CubeTable } from './read-cube.ts';

/** A color table as an image for `operator/color-lut`: squares of red (to the right) by green (down), one per value of blue. */
export interface LutImage {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Entries along each axis. */
  readonly size: number;
  /** Squares per row. */
  readonly columns: number;
  /** Top row first. */
  readonly rgba: Uint8Array;
}

/** Maximum size of tables in one row: 2,025 pixels, within the 2,048 that all WebGL 2 devices support. */
const MAX_IN_A_ROW = 45;

/** Larger tables and 1D tables become 64 entries per axis, in eight rows of eight squares, the common layout. */
const LARGE = 64;
const LARGE_COLUMNS = 8;

export function lutImage(table: CubeTable): LutImage {
  const plain = table.kind === '3D' && table.size <= MAX_IN_A_ROW;
  const size = plain ? table.size : LARGE;
  const columns = plain ? size : LARGE_COLUMNS;
  const widthPx = columns * size;
  const heightPx = (size / columns) * size;
  const rgba = new Uint8Array(widthPx * heightPx * 4);
  const last = size - 1;
  for (let b = 0; b < size; b++) {
    for (let g = 0; g < size; g++) {
      for (let r = 0; r < size; r++) {
        const x = (b % columns) * size + r;
        const y = Math.floor(b / columns) * size + g;
        const color = lookUp(table, [r / last, g / last, b / last]).map((value) => Math.round(255 * Math.min(Math.max(value, 0), 1)));
        rgba.set([...color, 255], (y * widthPx + x) * 4);
      }
    }
  }
  return { widthPx, heightPx, size, columns, rgba };
}

/** The color that the table maps a color to: interpolated linearly along each axis, clamped to its domain. */
export function lookUp(table: CubeTable, color: readonly [number, number, number]): number[] {
  const { kind, size, values, domainMin, domainMax } = table;
  const places = color.map((value, i) => {
    const [low = 0, high = 1] = [domainMin[i], domainMax[i]];
    return Math.min(Math.max((value - low) / (high - low), 0), 1) * (size - 1);
  });
  if (kind === '1D') {
    return places.map((place, channel) => {
      const below = Math.min(Math.floor(place), size - 2);
      const at = (i: number) => values[i * 3 + channel] ?? 0;
      return at(below) + (place - below) * (at(below + 1) - at(below));
    });
  }
  const result = [0, 0, 0];
  for (let corner = 0; corner < 8; corner++) {
    let weight = 1;
    let index = 0;
    places.forEach((place, axis) => {
      const below = Math.min(Math.floor(place), size - 2);
      const up = (corner >> axis) & 1;
      weight *= up ? place - below : 1 - (place - below);
      index += (below + up) * size ** axis;
    });
    for (let channel = 0; channel < 3; channel++) result[channel] = (result[channel] ?? 0) + weight * (values[index * 3 + channel] ?? 0);
  }
  return result;
}
