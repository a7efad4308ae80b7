import type { Place, Token } from '../syntax/token.ts';
import { KEYWORDS, RESERVED } from '../syntax/words.ts';

export type NameKind = 'function' | 'variable' | 'parameter' | 'struct' | 'member' | 'macro' | 'input' | 'image' | 'builtin';

export interface NameSignature {
  /** As written: `vec3 tint(vec3 color, float share)`. */
  readonly label: string;
  readonly returns: string;
  readonly parameters: readonly string[];
}

/** A name in a shader's text with all of its uses. Overloads of a function are one name. */
export interface ShaderName {
  readonly kind: NameKind;
  readonly name: string;
  /** As written: `vec3`, `Ray`, `float[]`; empty without a type. */
  readonly type: string;
  /** File of the declaration; null for the text itself. */
  readonly file: string | null;
  readonly doc: string;
  /** Tokens that declare it, in order; empty for names of the host. */
  readonly declarations: readonly Token[];
  /** All uses in the text, including declarations, in order. */
  readonly uses: readonly Token[];
  readonly signatures: readonly NameSignature[];
  readonly members: ReadonlyMap<string, ShaderName>;
  /** Where it is visible; null for everywhere. */
  readonly scope: { readonly from: Place; readonly to: Place } | null;
}

export interface Outline {
  readonly tokens: readonly Token[];
  /** Names declared in the text, in order; members are in their struct. */
  readonly names: readonly ShaderName[];
  /** The name that a token refers to, or null. */
  nameAt(token: Token): ShaderName | null;
  /** Included names with their tokens. */
  readonly includes: readonly { readonly name: string; readonly token: Token }[];
}

/** Whether a word can be a new name. */
export function isFreeWord(word: string): boolean {
  return (
    /^[A-Za-z_][A-Za-z0-9_]*$/.test(word) && !KEYWORDS.has(word) && !RESERVED.has(word) && !word.startsWith('gl_') && !word.includes('__')
  );
}
