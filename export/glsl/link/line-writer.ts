import type { SourceMap } from '../../program/program.ts';
import { ASSIGNMENTS } from '../syntax/parse-expression.ts';
import type { Place } from '../syntax/token.ts';
import { TYPES } from '../syntax/words.ts';

type MappedLine = SourceMap['lines'][number];

/** Builds a text line by line and remembers which author's line each one came from. */
export interface LineWriter {
  /**
   * Adds to the current line. With a place on another of the author's lines, a new line begins first, so that no printed line
   * holds text of two: drivers report lines only. Where tokens are kept apart, one also begins before a token that the line has.
   * `quoted`: as what drivers quote the token, where that is not as it is written.
   */
  write(text: string, place?: Place, quoted?: string): void;
  /** Ends the current line, if there is anything on it. */
  endLine(): void;
  /** Whole lines of the linker's own. */
  own(text: string): void;
  indent(by: 1 | -1): void;
  readonly lines: readonly string[];
  readonly map: readonly MappedLine[];
}

/** All assignments: drivers quote most by one word. */
export const ASSIGNMENT = 'assign';

/** How drivers quote what is written: calls by their name, but those of types, and assignments, by what they are. */
function quotedAs(text: string): string {
  const word = text.trim().replace(/\($/, '');
  if (word !== text.trim() && TYPES.has(word)) return 'constructor';
  return ASSIGNMENTS.has(word) ? ASSIGNMENT : word;
}

/** `apart`: no printed line has a token twice, or two constructors or assignments, so that what a driver quotes is one of them. */
export function createLineWriter(source: number, apart = false): LineWriter {
  const lines: string[] = [];
  const map: MappedLine[] = [];
  let current = '';
  let mapped: MappedLine = null;
  let depth = 0;
  const onLine = new Set<string>();

  function endLine(): void {
    const text = current.trimEnd();
    if (text !== '') {
      lines.push('  '.repeat(depth) + text);
      map.push(mapped);
    }
    current = '';
    mapped = null;
    onLine.clear();
  }

  return {
    lines,
    map,
    endLine,
    write: (text, place, quoted = quotedAs(text)) => {
      const isTwice = apart && onLine.has(quoted);
      if (place !== undefined && mapped !== null && (isTwice || mapped[1] !== place.line)) {
        endLine();
        current = '  ';
      }
      if (place !== undefined) {
        mapped ??= [source, place.line, place.column];
        onLine.add(quoted);
      }
      current += text;
    },
    own: (text) => {
      endLine();
      for (const line of text.split('\n')) {
        lines.push('  '.repeat(depth) + line);
        map.push(null);
      }
    },
    indent: (by) => {
      endLine();
      depth += by;
    },
  };
}
