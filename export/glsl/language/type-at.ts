import { swizzleType } from '../check/glsl-type.ts';
import type { Token } from '../syntax/token.ts';
import { TYPES } from '../syntax/words.ts';
import { openingOf } from './brackets.ts';
import { BUILTIN_FUNCTIONS } from './builtin-docs.ts';
import type { Outline, ShaderName } from './shader-name.ts';
import { ISF_FUNCTIONS } from './vocabulary.ts';

/** The type whose members can be accessed: a struct or a vector. */
export interface ValueType {
  readonly type: string;
  readonly struct: ShaderName | null;
}

const UNKNOWN: ValueType = { type: '', struct: null };

/** Type of the value whose last token is at `index`, as far as it is known without evaluating expressions. */
export function typeOfValue(outline: Outline, index: number, structs: ReadonlyMap<string, ShaderName>): ValueType {
  const { tokens } = outline;
  const token = tokens[index];
  if (token === undefined) return UNKNOWN;
  const named = (type: string): ValueType => ({ type, struct: structs.get(type) ?? null });
  if (token.text === ']') {
    const { type } = typeOfValue(outline, openingOf(tokens, index) - 1, structs);
    return named(elementOf(type));
  }
  if (token.text === ')') {
    const open = openingOf(tokens, index);
    const callee = tokens[open - 1];
    if (callee?.kind !== 'word') return typeOfValue(outline, index - 1, structs);
    return named(resultOf(outline, callee, open));
  }
  if (token.kind !== 'word') return UNKNOWN;
  if (tokens[index - 1]?.text === '.') return typeOfMember(typeOfValue(outline, index - 2, structs), token, structs);
  return named(outline.nameAt(token)?.type ?? '');

  function resultOf({ nameAt }: Outline, callee: Token, open: number): string {
    if (TYPES.has(callee.text)) return callee.text;
    const name = nameAt(callee);
    if (name?.kind === 'struct') return name.name;
    if (name !== null) return name.signatures[0]?.returns ?? '';
    const returns = (BUILTIN_FUNCTIONS.get(callee.text) ?? ISF_FUNCTIONS.get(callee.text))?.signatures[0]?.returns ?? '';
    // A function of all sizes returns the size of its argument; the first argument gives it if it is a single name.
    if (returns !== 'T') return returns;
    const first = tokens[open + 1];
    const alone = [',', ')'].includes(tokens[open + 2]?.text ?? '');
    return first?.kind === 'word' && alone ? (nameAt(first)?.type ?? '') : '';
  }
}

function typeOfMember(object: ValueType, member: Token, structs: ReadonlyMap<string, ShaderName>): ValueType {
  const type = object.struct?.members.get(member.text)?.type ?? swizzleType(object.type, member.text);
  return { type, struct: structs.get(type) ?? null };
}

/** The type of an element: `float` for `float[3]` and `vec3`, `vec3` for `mat3`. */
function elementOf(type: string): string {
  if (type.includes('[')) return type.slice(0, type.lastIndexOf('['));
  if (/^vec[234]$/.test(type)) return 'float';
  if (/^[iub]vec[234]$/.test(type)) return { i: 'int', u: 'uint', b: 'bool' }[type.charAt(0)] ?? '';
  const matrix = /^mat([234])(?:x([234]))?$/.exec(type);
  return matrix === null ? '' : `vec${matrix[2] ?? matrix[1]}`;
}
