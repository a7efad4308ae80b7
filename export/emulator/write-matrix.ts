/** Copies sixteen numbers into a matrix of iwer, whose type is not an array type. */
export function writeMatrix(target: { [index: number]: number }, source: ArrayLike<number>): void {
  for (let i = 0; i < 16; i++) target[i] = source[i] ?? 0;
}
