import type { Token } from './token.ts';
import { KEYWORDS, NEW_WORDS, QUALIFIERS, TYPES } from './words.ts';

/** Tokens that may follow a declared name. */
const BEHIND_NAME: ReadonlySet<string> = new Set([';', ',', '=', '(', ')', '[']);

/**
 * Renames names that are keywords in newer GLSL: `case`, `uint` or `mat4x3` are plain names in GLSL ES 1.00. If a source declares one, as
 * in `float case`, it is renamed everywhere.
 */
export function freeNames(tokens: readonly Token[]): readonly Token[] {
  const declared = new Set<string>();
  tokens.forEach((token, i) => {
    if (NEW_WORDS.has(token.text) && !declared.has(token.text) && isDeclared(tokens, i, declared)) declared.add(token.text);
  });
  if (declared.size === 0) return tokens;
  const taken = new Set(tokens.map(({ text }) => text));
  const names = new Map([...declared].map((name) => [name, unused(name, taken)]));
  return tokens.map((token) => {
    const text = names.get(token.text);
    return text === undefined ? token : { ...token, text };
  });
}

/** Restores renamed names in a message. */
export function asWritten(text: string): string {
  return text.replace(/\b(\w+)_es\d+\b/g, (name, word: string) => (NEW_WORDS.has(word) ? word : name));
}

function isDeclared(tokens: readonly Token[], at: number, declared: ReadonlySet<string>): boolean {
  const before = tokens[at - 1];
  const after = tokens[at + 1]?.text ?? '';
  if (before?.text === 'struct') return after === '{';
  if (!BEHIND_NAME.has(after)) return false;
  if (before?.text === ',') return isInList(tokens, at - 1);
  return before !== undefined && isType(before, declared);
}

function isType({ kind, text }: Token, declared: ReadonlySet<string>): boolean {
  return kind === 'word' && ((TYPES.has(text) && !declared.has(text)) || !KEYWORDS.has(text));
}

/** Whether the comma separates variables of a declaration: `float a = f(1.0, 2.0), case`. */
function isInList(tokens: readonly Token[], comma: number): boolean {
  let depth = 0;
  let at = comma;
  for (; at > 0; at -= 1) {
    const text = tokens[at - 1]?.text ?? '';
    if (text === ')' || text === ']') depth += 1;
    if (text === '(' || text === '[') depth -= 1;
    // An opening bracket before it contains parameters or arguments, except in the head of a loop.
    if (depth < 0 && tokens[at - 2]?.text !== 'for') return false;
    if (depth < 0 || (depth === 0 && (text === ';' || text === '{' || text === '}'))) break;
  }
  while (QUALIFIERS.has(tokens[at]?.text ?? '')) at += 1;
  const [type, name] = tokens.slice(at, at + 2);
  return type !== undefined && name?.kind === 'word' && isType(type, NONE);
}

const NONE: ReadonlySet<string> = new Set();

function unused(name: string, taken: ReadonlySet<string>): string {
  for (let version = 1; ; version += 1) {
    const candidate = `${name}_es${version}`;
    if (!taken.has(candidate)) return candidate;
  }
}
