import { lex } from '../syntax/lexer.ts';
import { GlslError, type Place, type Token } from '../syntax/token.ts';

/** `end` is exclusive. */
export interface TextRange {
  readonly start: Place;
  readonly end: Place;
}

/** A replacement of a range. */
export interface TextEdit extends TextRange {
  readonly text: string;
}

/** Tokens of an incomplete text; text after an unclosed comment is ignored. */
export function lexLeniently(source: string): readonly Token[] {
  try {
    return lex(source);
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    return lex(source.slice(0, offsetOf(source, error.place)));
  }
}

export function rangeOf({ line, column, text }: Pick<Token, 'line' | 'column' | 'text'>): TextRange {
  return { start: { line, column }, end: { line, column: column + text.length } };
}

export function isBefore(a: Place, b: Place): boolean {
  return a.line < b.line || (a.line === b.line && a.column < b.column);
}

/** Whether a position is in a range or at one of its ends, because a caret directly behind a name counts as at the name. */
export function touches({ start, end }: TextRange, place: Place): boolean {
  return !isBefore(place, start) && !isBefore(end, place);
}

/** Offset of a position, at most the end of the text. */
export function offsetOf(source: string, { line, column }: Place): number {
  let start = 0;
  for (let at = 1; at < line; at += 1) {
    const end = /\r\n|\r|\n/g;
    end.lastIndex = start;
    const found = end.exec(source);
    if (found === null) return source.length;
    start = found.index + found[0].length;
  }
  return Math.min(start + column - 1, source.length);
}

export function placeOf(source: string, offset: number): Place {
  const before = source.slice(0, offset).split(/\r\n|\r|\n/);
  return { line: before.length, column: (before.at(-1)?.length ?? 0) + 1 };
}

/** Applies edits that do not overlap, in any order. */
export function applyEdits(source: string, edits: readonly TextEdit[]): string {
  const placed = edits.map(({ start, end, text }) => ({ from: offsetOf(source, start), to: offsetOf(source, end), text }));
  placed.sort((a, b) => b.from - a.from);
  let result = source;
  for (const { from, to, text } of placed) result = result.slice(0, from) + text + result.slice(to);
  return result;
}
