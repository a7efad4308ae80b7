import { isBuiltinFunction } from '../check/builtin-functions.ts';
import type { GlslSymbol } from '../syntax/ast.ts';
import { asWritten } from '../syntax/free-names.ts';
import { KEYWORDS, RESERVED } from '../syntax/words.ts';

/**
 * Names of symbols in the printed text.
 *
 * Global names get the prefix `a_`, so that they differ from words and functions of GLSL ES 3.00, from the linker's, and from those of
 * other nodes in the same text. Local names stay, unless they are reserved or look like the linker's; then they get the prefix too, which
 * preserves hiding.
 */
export interface Names {
  of(symbol: GlslSymbol): string;
  /** Creates a new global name, as for a sampler. `suffixes` reserves the names that continue it. */
  fresh(name: string, suffixes?: readonly string[]): string;
  member(name: string): string;
}

/** Names of this form belong to the linker; authors' names are changed. */
const OURS = /^(?:[a-z]\d*|scrim|gl|webgl|_webgl)_/;

/** Names that the linker uses without a prefix. */
const GLOBALS: ReadonlySet<string> = new Set([
  'TIME',
  'TIMEDELTA',
  'FRAMEINDEX',
  'DATE',
  'RENDERSIZE',
  'PASSINDEX',
  'SCRIM_CLIP_FROM_VIEW',
  'SCRIM_WORLD_FROM_VIEW',
  'main',
]);

const GLOBAL_ROLES: ReadonlySet<string> = new Set(['global', 'varying', 'input', 'image']);

const PREFIX = 'a';

export function createNames(): Names {
  const names = new Map<GlslSymbol, string>();
  const taken = new Set<string>();
  // Overloads share a name.
  const functionNames = new Map<string, string>();

  function fresh(name: string, suffixes: readonly string[] = []): string {
    for (let version = 0; ; version += 1) {
      const candidate = apart(`${PREFIX}${version === 0 ? '' : version}_${name}`);
      const wanted = [candidate, ...suffixes.map((suffix) => candidate + suffix)];
      if (wanted.some((one) => taken.has(one))) continue;
      for (const one of wanted) taken.add(one);
      return candidate;
    }
  }

  function choose(symbol: GlslSymbol): string {
    if (symbol.kind === 'function') {
      const known = functionNames.get(symbol.name) ?? fresh(symbol.name);
      functionNames.set(symbol.name, known);
      return known;
    }
    const isGlobal = symbol.kind === 'struct' ? symbol.global : GLOBAL_ROLES.has(symbol.role);
    if (isGlobal || (symbol.kind === 'variable' && symbol.rename)) return fresh(symbol.name);
    return isPlain(symbol.name) ? symbol.name : apart(`${PREFIX}_${symbol.name}`);
  }

  return {
    fresh,
    of: (symbol) => {
      const known = names.get(symbol);
      if (known !== undefined) return known;
      const name = choose(symbol);
      names.set(symbol, name);
      return name;
    },
    member: (name) => (isWord(name) || OURS.test(name) || name.includes('__') ? apart(`${PREFIX}_${name}`) : name),
  };
}

/** Possible names of the author for a printed name, as drivers quote it; most likely first. */
export function authorsNames(printed: string): readonly string[] {
  return [printed.replace(ADDED, ''), printed.replace(/_u(?=_)/g, '_').replace(ADDED, '')].map(asWritten);
}

const ADDED = /^[a-z]\d*_/;

/** Separates consecutive underscores in a name by `u`, because WebGL rejects names with two of them in a row. */
function apart(name: string): string {
  return name.replace(/_(?=_)/g, '_u');
}

function isPlain(name: string): boolean {
  return !isWord(name) && !isBuiltinFunction(name) && !GLOBALS.has(name) && !OURS.test(name) && !name.includes('__');
}

function isWord(name: string): boolean {
  return RESERVED.has(name) || KEYWORDS.has(name);
}
