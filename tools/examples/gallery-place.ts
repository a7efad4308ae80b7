/**
 * Height of a rail, and distance between the centers of cells, in meters. An upright phone with a horizontal view of 30° shows the whole
 * wall.
 */
export const RAIL_M = 0.083;
const PITCH_M = 0.13;
const COLUMNS = 6;
const ROWS = 9;

/** Center of the wall: slightly below the eyes of a viewer at the origin. */
export const MIDDLE_M = [0, 1.3, -1.6] as const;

export const WALL_M = { width: COLUMNS * PITCH_M, height: ROWS * PITCH_M } as const;

export type Place = readonly [xM: number, yM: number, zM: number];

/** Name of a cell: its row as a letter and its column from 1. Ids of its nodes end with it. */
export function cellKey(row: number, column: number): string {
  return `${'abcdefghi'[row]}${column + 1}`;
}

/** Center of a cell, or of `columns` cells in a row. */
export function cellMiddleM(row: number, column: number, columns = 1): Place {
  const [x, y, z] = MIDDLE_M;
  const right = column + (columns - 1) / 2 - (COLUMNS - 1) / 2;
  return [round(x + right * PITCH_M), round(y + ((ROWS - 1) / 2 - row) * PITCH_M), z];
}

/** Foot of the rail in a cell. */
export function cellFootM(row: number, column: number): Place {
  return moved(cellMiddleM(row, column), 0, -RAIL_M / 2, 0);
}

export function moved([x, y, z]: Place, rightM: number, upM: number, nearM: number): Place {
  return [round(x + rightM), round(y + upM), round(z + nearM)];
}

/** Rounds positions, so that they have few digits. */
function round(meters: number): number {
  return Math.round(meters * 10_000) / 10_000;
}
