/** The comment directly above a line, without its marks; empty if there is none. `line` counts from 1. */
export function commentAbove(lines: readonly string[], line: number): string {
  const found: string[] = [];
  for (let at = line - 2; at >= 0; at -= 1) {
    const text = (lines[at] ?? '').trim();
    const comment = /^\/\/+\s?(.*)$/.exec(text) ?? /^\/\*+\s?(.*?)\s*\*+\/$/.exec(text);
    if (comment === null) break;
    found.unshift(comment[1] ?? '');
  }
  return found.join(' ').trim();
}
