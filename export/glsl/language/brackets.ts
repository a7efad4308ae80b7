import type { Token } from '../syntax/token.ts';

/** Index of the bracket that closes the one at `index`; the number of tokens if there is none. */
export function closingOf(tokens: readonly Token[], index: number): number {
  const open = tokens[index]?.text ?? '';
  const close = { '(': ')', '[': ']', '{': '}' }[open];
  let depth = 0;
  for (let at = index; at < tokens.length; at += 1) {
    if (tokens[at]?.text === open) depth += 1;
    if (tokens[at]?.text === close) depth -= 1;
    if (depth === 0) return at;
  }
  return tokens.length;
}

/** Index of the bracket that the one at `index` closes; -1 if there is none. */
export function openingOf(tokens: readonly Token[], index: number): number {
  const close = tokens[index]?.text ?? '';
  const open = { ')': '(', ']': '[', '}': '{' }[close];
  let depth = 0;
  for (let at = index; at >= 0; at -= 1) {
    if (tokens[at]?.text === close) depth += 1;
    if (tokens[at]?.text === open) depth -= 1;
    if (depth === 0) return at;
  }
  return -1;
}
