import { checkCalls } from '../check/check-calls.ts';
import { type CheckedShader, checkShader } from '../check/check-shader.ts';
import type { ParsedShader, VariableSymbol } from '../syntax/ast.ts';
import { parseShader } from '../syntax/parse.ts';
import { inFile } from '../syntax/token.ts';
import { parseTransition } from '../transition/parse-transition.ts';
import { givenSymbols } from './given-symbols.ts';
import type { IsfShader } from './isf-shader.ts';

/** The checked GLSL of an ISF file and the variables that the host declares. */
export interface CheckedIsf {
  readonly given: ReadonlyMap<string, VariableSymbol>;
  readonly checked: CheckedShader;
  /** The vertex shader; null if there is none. */
  readonly vertex: { readonly given: ReadonlyMap<string, VariableSymbol>; readonly checked: CheckedShader } | null;
}

/**
 * Results of `checkIsf`. Checked trees do not change, so the definition and every variant of the link share them as long as the header
 * exists.
 */
const known = new WeakMap<IsfShader, CheckedIsf>();

/**
 * Checks the GLSL of an ISF file. `partial`: functions may lack their bodies.
 *
 * @throws GlslError with the file of the mistake.
 */
export function checkIsf(shader: IsfShader, partial = false): CheckedIsf {
  const before = known.get(shader);
  if (before !== undefined) return before;
  const given = givenSymbols(shader);
  const made = { given, checked: checkWhole(parse(shader), given, partial), vertex: checkVertex(shader, partial) };
  known.set(shader, made);
  return made;
}

function checkWhole(parsed: ParsedShader, given: ReadonlyMap<string, VariableSymbol>, partial: boolean): CheckedShader {
  const checked = checkShader(parsed, given);
  checkCalls(checked, (name) => partial || VERTEX_STARTS.has(name));
  return checked;
}

/** Functions of other hosts that authors declare by a prototype and call in vertex shaders; the linker defines them. */
const VERTEX_STARTS: ReadonlySet<string> = new Set(['isf_vertShaderInit', 'vv_vertShaderInit']);

function parse(shader: IsfShader): ParsedShader {
  return shader.dialect === 'transition' ? parseTransition(shader) : parseShader(shader.source, macrosOf(shader));
}

/** Macros that are predefined for a shader: `SCRIM_SCENE` tells a shader for either encoding that its layers are linear and unclamped. */
function macrosOf({ readsScene }: IsfShader): Readonly<Record<string, number>> {
  return readsScene ? { SCRIM_SCENE: 1 } : {};
}

function checkVertex(shader: IsfShader, partial: boolean): CheckedIsf['vertex'] {
  if (shader.vertex === null) return null;
  const given = givenSymbols(shader, 'vertex');
  return inFile(shader.vertex.file, () => ({
    given,
    checked: checkWhole(parseShader(shader.vertex?.source ?? '', macrosOf(shader)), given, partial),
  }));
}
