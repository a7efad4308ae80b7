import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { TOO_LONG } from '../syntax/parse.ts';
import { textAbove } from '../syntax/text-above.ts';
import type { Place } from '../syntax/token.ts';
import { linkIsf } from './link-isf.ts';
import type { LinkedPass, LinkOptions } from './linked-pass.ts';

/** The linked text above a mistake. */
export interface Above<T> {
  /**
   * The linked text, in which the driver finds further mistakes; null if nothing could be linked. Its classification of loops is not
   * meaningful, because their bodies may be incomplete.
   */
  readonly output: T | null;
  /** Mistakes above that were found without a driver. */
  readonly diagnostics: readonly Diagnostic[];
  readonly before: Before;
}

/** The mistake above which the text ends. Diagnostics of the text count only if they are in another file or before this position. */
export interface Before {
  readonly file: string;
  readonly place: Place;
}

/**
 * Links the text above the mistake for which `linkIsf` rejected the file, so that mistakes above it can be reported too. Returns null if
 * there is no text above.
 */
export function linkAbove(shader: IsfShader, options: LinkOptions, refused: Diagnostic): Above<readonly LinkedPass[]> | null {
  return findAbove(shader, refused, shaderAbove, (above) => linkIsf(above, { ...options, partial: true }));
}

/**
 * Links the text of `source` above a mistake. `cut` returns that text, or null if there is none. If `link` rejects it for an earlier
 * mistake, the text above that one is linked, and so on.
 */
export function findAbove<S, T>(
  source: S,
  { file, line, column, message }: Diagnostic,
  cut: (source: S, file: string, place: Place) => S | null,
  link: (above: S) => Result<T>,
): Above<T> | null {
  if (file === undefined || line === undefined || column === undefined || message === TOO_LONG) return null;
  const above = cut(source, file, { line, column });
  if (above === null) return null;
  const { output, diagnostics } = link(above);
  const before = { file, place: { line, column } };
  const told = diagnostics.filter((diagnostic) => countsAbove(diagnostic, before));
  if (output !== null) return { output, diagnostics: told, before };
  const [refused] = told;
  if (refused === undefined) return null;
  const further = findAbove(above, refused, cut, link);
  return further === null ? { output: null, diagnostics: told, before } : { ...further, diagnostics: [...further.diagnostics, refused] };
}

/** Whether a diagnostic of the text above a mistake is valid, because the end of that text is not the author's. */
export function countsAbove({ file, line, column }: Diagnostic, { file: cut, place }: Before): boolean {
  if (line === undefined || column === undefined) return false;
  return file !== cut || line < place.line || (line === place.line && column < place.column);
}

const MAIN = 'void main() {}';
const TRANSITION = 'vec4 transition(vec2 uv) { return vec4(0.0); }';

function shaderAbove(shader: IsfShader, file: string, place: Place): IsfShader | null {
  const { vertex, dialect } = shader;
  if (file === vertex?.file) {
    const source = textAbove(vertex.source, place, MAIN);
    return source === null ? null : { ...shader, vertex: { ...vertex, source } };
  }
  if (file !== shader.file) return null;
  const source = textAbove(shader.source, place, dialect === 'transition' ? TRANSITION : MAIN);
  return source === null ? null : { ...shader, source };
}
