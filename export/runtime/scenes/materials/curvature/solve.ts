/**
 * Solves a symmetric positive definite system by Cholesky's method; `rows` is overwritten.
 *
 * @returns The solution; null if the matrix is singular within rounding.
 */
export function solve(rows: number[][], right: readonly number[]): number[] | null {
  const size = right.length;
  const solution = [...right];
  const at = (i: number, j: number): number => rows[i]?.[j] ?? 0;
  let largest = 0;
  for (let i = 0; i < size; i++) largest = Math.max(largest, at(i, i));
  for (let j = 0; j < size; j++) {
    let pivot = at(j, j);
    for (let k = 0; k < j; k++) pivot -= at(j, k) ** 2;
    if (!(pivot > largest * 1e-9)) return null;
    const root = Math.sqrt(pivot);
    for (let i = j; i < size; i++) {
      let value = at(i, j);
      for (let k = 0; k < j; k++) value -= at(i, k) * at(j, k);
      const row = rows[i];
      if (row) row[j] = i === j ? root : value / root;
    }
  }
  for (let i = 0; i < size; i++) {
    for (let k = 0; k < i; k++) solution[i] = (solution[i] ?? 0) - at(i, k) * (solution[k] ?? 0);
    solution[i] = (solution[i] ?? 0) / at(i, i);
  }
  for (let i = size - 1; i >= 0; i--) {
    for (let k = i + 1; k < size; k++) solution[i] = (solution[i] ?? 0) - at(k, i) * (solution[k] ?? 0);
    solution[i] = (solution[i] ?? 0) / at(i, i);
  }
  return solution;
}
