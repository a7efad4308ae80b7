import { lex } from './lexer.ts';
import { GlslError, type Token } from './token.ts';

/** `#define NAME body`, or with parameters `#define NAME(a, b) body`. */
export interface Macro {
  readonly name: string;
  readonly parameters: readonly string[] | null;
  readonly body: readonly Token[];
}

export type MacroTable = Map<string, Macro>;

/**
 * Maximum number of tokens that all expansions of a source give together, because nested macros can expand to more than the memory holds.
 */
const MAX_EXPANDED_TOKENS = 200_000;

/** Maximum nesting of macro uses in arguments. */
const MAX_NESTING = 100;

/** Remaining tokens of all expansions of one source, and the current nesting. */
export interface ExpansionBudget {
  left: number;
  nesting: number;
}

export function createExpansionBudget(): ExpansionBudget {
  return { left: MAX_EXPANDED_TOKENS, nesting: 0 };
}

/**
 * Expands macros (Prosser's algorithm, on which the C standard is based: each token has the set of macros that produced it, which are not
 * expanded in it again). Text of a macro's body has the position of its use; arguments keep their own.
 */
export function expandMacros(tokens: readonly Token[], macros: MacroTable, budget: ExpansionBudget): Token[] {
  const output: Token[] = [];
  const pending = [...tokens].reverse();
  for (let token = pending.pop(); token !== undefined; token = pending.pop()) {
    const replacement = expandOne(token, pending, macros, budget);
    if (replacement === null) {
      output.push(token);
      continue;
    }
    budget.left -= replacement.length + 1;
    if (budget.left < 0) throw new GlslError(token, `The macro "${token.text}" and those inside it expand to too much text.`);
    for (let i = replacement.length - 1; i >= 0; i -= 1) pending.push(replacement[i] as Token);
  }
  return output;
}

function expandOne(token: Token, pending: Token[], macros: MacroTable, budget: ExpansionBudget): Token[] | null {
  if (token.kind !== 'word' || token.hidden?.has(token.text)) return null;
  if (token.text === '__LINE__') return [{ ...token, kind: 'int', text: String(token.line) }];
  const macro = macros.get(token.text);
  if (macro === undefined) return null;
  if (macro.parameters === null) return substitute(macro, token, [], unite(token.hidden, macro.name), macros, budget);
  if (pending.at(-1)?.text !== '(') return null;
  const call = takeArguments(token, pending);
  const args = call.args.length === 1 && call.args[0]?.length === 0 && macro.parameters.length === 0 ? [] : call.args;
  if (args.length !== macro.parameters.length) {
    throw new GlslError(
      token,
      `The macro "${macro.name}" takes ${count(macro.parameters.length)}, but ${args.length} ${args.length === 1 ? 'is' : 'are'} given.`,
    );
  }
  return substitute(macro, token, args, unite(intersect(token.hidden, call.close.hidden), macro.name), macros, budget);
}

function substitute(
  macro: Macro,
  use: Token,
  args: readonly (readonly Token[])[],
  hidden: ReadonlySet<string>,
  macros: MacroTable,
  budget: ExpansionBudget,
): Token[] {
  const output: Token[] = [];
  const expandedArgs: (Token[] | undefined)[] = [];

  function partsFor(token: Token, glued: boolean): readonly Token[] {
    const index = token.kind === 'word' && macro.parameters !== null ? macro.parameters.indexOf(token.text) : -1;
    if (index < 0) return [{ ...token, line: use.line, column: use.column }];
    if (glued) return args[index] ?? [];
    expandedArgs[index] ??= expandArgument(args[index] ?? [], use, macros, budget);
    return expandedArgs[index] ?? [];
  }

  const { body } = macro;
  body.forEach((token, at) => {
    if (token.text === GLUE) return;
    const gluedBefore = body[at - 1]?.text === GLUE;
    const parts = partsFor(token, gluedBefore || body[at + 1]?.text === GLUE).map((part) => ({
      ...part,
      hidden: uniteAll(part.hidden, hidden),
    }));
    const [first, ...rest] = parts;
    const before = gluedBefore && first ? output.pop() : undefined;
    for (const part of before && first ? [glue(before, first, use), ...rest] : parts) output.push(part);
    if (output.length > MAX_EXPANDED_TOKENS) throw new GlslError(use, `The macro "${macro.name}" expands to too much text.`);
  });
  return output;
}

/**
 * The operator that joins tokens in a macro. Desktop drivers support it as C does (C11 §6.10.3.3): `a ## b` joins two words, and arguments
 * next to it are not expanded.
 */
const GLUE = '##';

function glue(before: Token, after: Token, use: Token): Token {
  const text = before.text + after.text;
  const [made, end] = lex(text);
  if (made === undefined || end?.kind !== 'end') throw new GlslError(use, `"##" makes "${text}" here, which is no word of GLSL.`);
  return { ...before, kind: made.kind, text };
}

function expandArgument(argument: readonly Token[], use: Token, macros: MacroTable, budget: ExpansionBudget): Token[] {
  if (budget.nesting >= MAX_NESTING) throw new GlslError(use, `The uses of the macro "${use.text}" are nested too deeply.`);
  budget.nesting += 1;
  const expanded = expandMacros(argument, macros, budget);
  budget.nesting -= 1;
  return expanded;
}

/** Consumes `( … )` from `pending`, split at the commas outside of inner brackets. */
function takeArguments(use: Token, pending: Token[]): { args: Token[][]; close: Token } {
  pending.pop();
  const args: Token[][] = [[]];
  let depth = 0;
  for (let token = pending.pop(); token !== undefined && token.kind !== 'end'; token = pending.pop()) {
    if (token.text === ')' && depth === 0) return { args, close: token };
    if (token.text === ',' && depth === 0) {
      args.push([]);
      continue;
    }
    if (token.text === '(') depth += 1;
    if (token.text === ')') depth -= 1;
    args.at(-1)?.push(token);
  }
  throw new GlslError(use, `The brackets after the macro "${use.text}" are never closed.`);
}

function count(parameters: number): string {
  return parameters === 1 ? '1 argument' : `${parameters} arguments`;
}

function unite(hidden: ReadonlySet<string> | null, name: string): ReadonlySet<string> {
  return new Set(hidden ?? []).add(name);
}

function uniteAll(a: ReadonlySet<string> | null, b: ReadonlySet<string>): ReadonlySet<string> {
  if (a === null) return b;
  if (a === b) return a;
  return new Set([...a, ...b]);
}

function intersect(a: ReadonlySet<string> | null, b: ReadonlySet<string> | null): ReadonlySet<string> | null {
  if (a === null || b === null) return null;
  const both = new Set([...a].filter((name) => b.has(name)));
  return both.size === 0 ? null : both;
}
