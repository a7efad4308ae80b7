/** Text that suggests the nearest known word: `exprot` → ` Did you mean "export"?`. Empty if none is near enough. */
export function didYouMean(given: string, known: readonly string[]): string {
  const near = nearest(given, known);
  return near === null ? '' : ` Did you mean ${JSON.stringify(near)}?`;
}

/** The known word that is nearest to a given word, with at most one typo in short words and two in longer ones; null if there is none. */
export function nearest(given: string, known: readonly string[]): string | null {
  const ranked = known.map((word) => ({ word, slips: slipsBetween(given.toLowerCase(), word.toLowerCase()) }));
  ranked.sort((a, b) => a.slips - b.slips);
  const [best] = ranked;
  return best && best.slips <= (best.word.length < 5 ? 1 : 2) ? best.word : null;
}

/** Number of added, missing, changed or swapped letters (optimal string alignment). */
function slipsBetween(a: string, b: string): number {
  const rows = Array.from({ length: a.length + 1 }, (_, i) => [i, ...Array.from({ length: b.length }, () => 0)]);
  const at = (i: number, j: number): number => (i === 0 ? j : (rows[i]?.[j] ?? 0));
  for (let i = 1; i <= a.length; i++) {
    for (let j = 1; j <= b.length; j++) {
      const changed = at(i - 1, j - 1) + (a[i - 1] === b[j - 1] ? 0 : 1);
      const swapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1] ? at(i - 2, j - 2) + 1 : Number.POSITIVE_INFINITY;
      const row = rows[i];
      if (row) row[j] = Math.min(at(i - 1, j) + 1, at(i, j - 1) + 1, changed, swapped);
    }
  }
  return at(a.length, b.length);
}
