/**
 * Whether two values of plain data are equal: primitives, arrays, sets and objects, with the keys and entries in the same order. The order
 * counts because diagnostics and slots have the order of the project's nodes and params.
 */
export function isSame(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (a instanceof Set || b instanceof Set) return a instanceof Set && b instanceof Set && isSame([...a], [...b]);
  if (Array.isArray(a) !== Array.isArray(b)) return false;
  const keys = Object.keys(a);
  const others = Object.keys(b);
  if (keys.length !== others.length) return false;
  return keys.every((key, i) => key === others[i] && isSame((a as Values)[key], (b as Values)[key]));
}

type Values = Readonly<Record<string, unknown>>;
