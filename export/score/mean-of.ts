/** A sum over pixels, so that means over several frames weigh each pixel alike. */
export interface Sum {
  readonly sum: number;
  readonly count: number;
}

/** The mean of sums together; NaN if they count nothing. */
export function meanOf(sums: readonly Sum[]): number {
  return sums.reduce((total, { sum }) => total + sum, 0) / sums.reduce((total, { count }) => total + count, 0);
}
