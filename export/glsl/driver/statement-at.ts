import type { Place, Token } from '../syntax/token.ts';

const ENDS = new Set([';', '{', '}']);

/** The tokens of the author's statement at a position; empty if the text is unknown. */
export function statementAt(tokens: readonly Token[], place: Place): readonly Token[] {
  const behind = tokens.findIndex((token) => isBefore(place, token));
  const at = (behind < 0 ? tokens.length : behind) - 1;
  let start = at;
  while (start > 0 && !ENDS.has(tokens[start - 1]?.text ?? ';')) start -= 1;
  let end = at;
  while (end < tokens.length && !ENDS.has(tokens[end]?.text ?? ';')) end += 1;
  return at < 0 ? [] : tokens.slice(start, end);
}

/** The tokens in the brackets after the token at a position. */
export function argumentsAt(statement: readonly Token[], place: Place): readonly Token[] {
  const at = statement.findIndex((token) => token.line === place.line && token.column === place.column);
  if (at < 0 || statement[at + 1]?.text !== '(') return [];
  let depth = 0;
  for (let i = at + 1; i < statement.length; i++) {
    const { text } = statement[i] as Token;
    if (text === '(') depth += 1;
    if (text === ')') depth -= 1;
    if (depth === 0) return statement.slice(at + 2, i);
  }
  return statement.slice(at + 2);
}

export function isBefore(a: Place, b: Place): boolean {
  return a.line < b.line || (a.line === b.line && a.column < b.column);
}
