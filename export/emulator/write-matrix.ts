/** Sixteen numbers into one of iwer's matrices, whose type is not quite an array. */
export function writeMatrix(target: { [index: number]: number }, source: ArrayLike<number>): void {
  for (let i = 0; i < 16; i++) target[i] = source[i] ?? 0;
}
