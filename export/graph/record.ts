/**
 * Reads an own property of a record. Names in documents are arbitrary, `constructor` included, so inherited properties must not
 * be found.
 *
 * @returns The value, or undefined where the record has no such key of its own.
 */
export function getOwn<T>(record: Readonly<Record<string, T>>, key: string): T | undefined {
  return Object.hasOwn(record, key) ? record[key] : undefined;
}

/** Compares by code units, so that the order is the same on every machine and in every language; for `Array.sort`. */
export function compareText(a: string, b: string): number {
  if (a === b) return 0;
  return a < b ? -1 : 1;
}

/** @returns The entries of a record, sorted by key. */
export function sortedEntries<T>(record: Readonly<Record<string, T>>): [string, T][] {
  return Object.entries(record).sort(([a], [b]) => compareText(a, b));
}
