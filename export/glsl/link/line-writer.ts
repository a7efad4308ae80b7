import type { SourceMap } from '../../program/program.ts';
import { ASSIGNMENTS } from '../syntax/parse-expression.ts';
import type { Place } from '../syntax/token.ts';
import { TYPES } from '../syntax/words.ts';

type MappedLine = SourceMap['lines'][number];

/** Builds a text line by line and records the author's line of each. */
export interface LineWriter {
  /**
   * Adds text to the current line. If `place` is on another line of the author, a new line starts, so that each printed line comes from one
   * line of the author: drivers report lines, but not columns. If tokens are kept apart (`apart` of `createLineWriter`), a new line also
   * starts before a token that the current line already contains. `quoted` is how drivers quote the token, if it differs from the text.
   */
  write(text: string, place?: Place, quoted?: string): void;
  /** Ends the current line if it is not empty. */
  endLine(): void;
  /** Adds whole lines of the linker. */
  own(text: string): void;
  /** Adds printed lines as they are. */
  append(printed: MappedLines): void;
  indent(by: 1 | -1): void;
  readonly lines: readonly string[];
  readonly map: readonly MappedLine[];
}

/** Printed lines, and the author's line of each. */
export type MappedLines = Pick<LineWriter, 'lines' | 'map'>;

/** How most drivers quote an assignment operator, whichever it is. */
export const ASSIGNMENT = 'assign';

/** How drivers quote a text: calls by name, but constructors and assignments by kind. */
function quotedAs(text: string): string {
  const word = text.trim().replace(/\($/, '');
  if (word !== text.trim() && TYPES.has(word)) return 'constructor';
  return ASSIGNMENTS.has(word) ? ASSIGNMENT : word;
}

/**
 * Creates a line writer. `apart`: no printed line has a token twice, or two constructors or assignments, so that the token that a driver
 * quotes is unique.
 */
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
    append: (printed) => {
      endLine();
      for (const line of printed.lines) lines.push(line);
      for (const place of printed.map) map.push(place);
    },
    indent: (by) => {
      endLine();
      depth += by;
    },
  };
}
