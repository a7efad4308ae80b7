/** A path as one argument of a shell. */
export function quoted(path: string): string {
  return /^[\w./:@%+,=-]+$/.test(path) ? path : JSON.stringify(path);
}
