import { GlslError, type Place } from '../syntax/token.ts';

/** A text assembled from several files. */
export interface ExpandedText {
  readonly text: string;
  /** The files, the author's first. */
  readonly sources: readonly string[];
  /** Per line: index into `sources` and the line there, from 1. */
  readonly lines: readonly (readonly [source: number, line: number])[];
}

const INCLUDE = /^\s*#\s*include\s+[<"]([A-Za-z0-9/_-]+)[>"]\s*$/;

/**
 * Replaces `#include <noise/simplex-3d>` by the text of chunks, each once and after those that it includes. `chunkOf` returns the text of
 * `chunks/NAME.glsl`.
 *
 * @throws GlslError at the author's line if a chunk does not exist.
 */
export function expandIncludes(source: string, file: string, chunkOf: (name: string) => string | undefined): ExpandedText {
  const sources = [file];
  const text: string[] = [];
  const lines: (readonly [number, number])[] = [];
  const included = new Set<string>();

  function add(content: string, index: number, place: Place | null): void {
    for (const [i, line] of content.split(/\r\n|\r|\n/).entries()) {
      const name = INCLUDE.exec(line)?.[1];
      if (name === undefined) {
        text.push(line);
        lines.push([index, i + 1]);
        continue;
      }
      // Keeps a line, so that text after it is not attributed to the chunk.
      text.push('');
      lines.push([index, i + 1]);
      if (included.has(name)) continue;
      included.add(name);
      const asked = place ?? { line: i + 1, column: line.indexOf('#') + 1 };
      const chunk = chunkOf(name);
      if (chunk === undefined) throw new GlslError(asked, `The chunk “${name}” does not exist.`, 'SCR043');
      add(chunk, sources.push(`chunks/${name}.glsl`) - 1, asked);
    }
  }

  add(source, 0, null);
  return { text: text.join('\n'), sources, lines };
}
