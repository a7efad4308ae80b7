/**
 * Reads an own property of a record. Names in documents are arbitrary, including `constructor`, so inherited properties must be ignored.
 *
 * @returns The value, or undefined if the record does not have the key itself.
 *
 * @example
 * getOwn({ sepia: 1 }, 'sepia'); // 1
 * getOwn({ sepia: 1 }, 'constructor'); // undefined
 */
export function getOwn<T>(record: Readonly<Record<string, T>>, key: string): T | undefined {
  return Object.hasOwn(record, key) ? record[key] : undefined;
}

/** Compares by code units, for `Array.sort`, so that the order does not depend on the machine or language. */
export function compareText(a: string, b: string): number {
  if (a === b) return 0;
  return a < b ? -1 : 1;
}

/**
 * @returns The entries of a record, sorted by key.
 *
 * @example
 * sortedEntries({ b: 1, a: 2 }); // [['a', 2], ['b', 1]]
 */
export function sortedEntries<T>(record: Readonly<Record<string, T>>): [string, T][] {
  return Object.entries(record).sort(([a], [b]) => compareText(a, b));
}
