import { type CheckedShader, checkShader } from '../check/check-shader.ts';
import type { VariableSymbol } from '../syntax/ast.ts';
import { parseShader } from '../syntax/parse.ts';
import { givenSymbols } from './given-symbols.ts';
import type { IsfShader } from './isf-shader.ts';

/** The GLSL of an ISF file with all its names known, and the variables that the host gives it. */
export interface CheckedIsf {
  readonly given: ReadonlyMap<string, VariableSymbol>;
  readonly checked: CheckedShader;
}

/**
 * Nobody changes a tree once it is checked, so the definition and every variant of the link share the one of a header that was
 * read once. It goes when the header goes.
 */
const known = new WeakMap<IsfShader, CheckedIsf>();

/** Throws `GlslError`. */
export function checkIsf(shader: IsfShader): CheckedIsf {
  const before = known.get(shader);
  if (before !== undefined) return before;
  const given = givenSymbols(shader);
  const made = { given, checked: checkShader(parseShader(shader.source), given) };
  known.set(shader, made);
  return made;
}
