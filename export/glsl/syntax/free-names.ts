import type { Token } from './token.ts';
import { KEYWORDS, NEW_WORDS, QUALIFIERS, TYPES } from './words.ts';

/** What may stand behind a name that is being declared. */
const BEHIND_NAME: ReadonlySet<string> = new Set([';', ',', '=', '(', ')', '[']);

/**
 * `case`, `uint` or `mat4x3` are plain names in GLSL ES 1.00. In a source that declares one, as in `float case`, it is a name
 * everywhere, and gets one that newer GLSL takes as well.
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

/** A text about a source, with the names that were freed as their author wrote them. */
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

/** Whether the comma stands between the variables of a declaration: `float a = f(1.0, 2.0), case`. */
function isInList(tokens: readonly Token[], comma: number): boolean {
  let depth = 0;
  let at = comma;
  for (; at > 0; at -= 1) {
    const text = tokens[at - 1]?.text ?? '';
    if (text === ')' || text === ']') depth += 1;
    if (text === '(' || text === '[') depth -= 1;
    // What opens before it encloses parameters or arguments, but in a loop's head.
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
