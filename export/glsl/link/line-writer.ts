import type { SourceMap } from '../../program/program.ts';
import type { Place } from '../syntax/token.ts';

type MappedLine = SourceMap['lines'][number];

/** Builds a text line by line and remembers which author's line each one came from. */
export interface LineWriter {
  /**
   * Adds to the current line. With a place on another of the author's lines, a new line begins first, so that no printed line
   * holds text of two: drivers report lines only.
   */
  write(text: string, place?: Place): void;
  /** Ends the current line, if there is anything on it. */
  endLine(): void;
  /** Whole lines of the linker's own. */
  own(text: string): void;
  indent(by: 1 | -1): void;
  readonly lines: readonly string[];
  readonly map: readonly MappedLine[];
}

export function createLineWriter(source: number): LineWriter {
  const lines: string[] = [];
  const map: MappedLine[] = [];
  let current = '';
  let mapped: MappedLine = null;
  let depth = 0;

  function endLine(): void {
    const text = current.trimEnd();
    if (text !== '') {
      lines.push('  '.repeat(depth) + text);
      map.push(mapped);
    }
    current = '';
    mapped = null;
  }

  return {
    lines,
    map,
    endLine,
    write: (text, place) => {
      if (place !== undefined && mapped !== null && mapped[1] !== place.line) {
        endLine();
        current = '  ';
      }
      if (place !== undefined) mapped ??= [source, place.line, place.column];
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
