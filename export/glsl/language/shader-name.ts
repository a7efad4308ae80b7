import type { Place, Token } from '../syntax/token.ts';
import { KEYWORDS, RESERVED } from '../syntax/words.ts';

export type NameKind = 'function' | 'variable' | 'parameter' | 'struct' | 'member' | 'macro' | 'input' | 'image' | 'builtin';

export interface NameSignature {
  /** As the author wrote it: `vec3 tint(vec3 color, float share)`. */
  readonly label: string;
  readonly returns: string;
  readonly parameters: readonly string[];
}

/** Something that a shader's text gives a name, with every place that names it. All overloads of a function are one. */
export interface ShaderName {
  readonly kind: NameKind;
  readonly name: string;
  /** As written: `vec3`, `Ray`, `float[]`; empty where it has none. */
  readonly type: string;
  /** File that declares it; null for the text itself. */
  readonly file: string | null;
  readonly doc: string;
  /** Names that declare it, the first one first; none for what the host declares. */
  readonly declarations: readonly Token[];
  /** Places in the text itself that name it, those that declare it included, in order. */
  readonly uses: readonly Token[];
  readonly signatures: readonly NameSignature[];
  readonly members: ReadonlyMap<string, ShaderName>;
  /** Where it can be used; null for everywhere. */
  readonly scope: { readonly from: Place; readonly to: Place } | null;
}

export interface Outline {
  readonly tokens: readonly Token[];
  /** Declared in the text, in its order; members stand in their struct. */
  readonly names: readonly ShaderName[];
  /** What a token names, where that is known. */
  nameAt(token: Token): ShaderName | null;
  /** Names to `#include`, with their places. */
  readonly includes: readonly { readonly name: string; readonly token: Token }[];
}

/** Whether a word is free to be the name of something new. */
export function isFreeWord(word: string): boolean {
  return (
    /^[A-Za-z_][A-Za-z0-9_]*$/.test(word) && !KEYWORDS.has(word) && !RESERVED.has(word) && !word.startsWith('gl_') && !word.includes('__')
  );
}
