import { evaluateCondition } from './condition.ts';
import { lex } from './lexer.ts';
import { createExpansionBudget, type ExpansionBudget, expandMacros, type Macro, type MacroTable } from './macro.ts';
import { GlslError, type Token } from './token.ts';

/**
 * Predefined macros. `SCRIM` identifies Scrim among ISF hosts. `__VERSION__` is that of the printed text, also for older text, which is
 * converted: both branches of an `#if` over the version work.
 */
const PREDEFINED: Readonly<Record<string, number>> = {
  SCRIM: 1,
  GL_ES: 1,
  GL_FRAGMENT_PRECISION_HIGH: 1,
  GL_OES_standard_derivatives: 1,
  GL_EXT_shader_texture_lod: 1,
  __VERSION__: 300,
  __FILE__: 0,
};

/** Extensions that are part of GLSL ES 3.00. */
const EXTENSIONS_IN_CORE = new Set([
  'all',
  'GL_OES_standard_derivatives',
  'GL_EXT_shader_texture_lod',
  'GL_ARB_shader_texture_lod',
  'GL_EXT_gpu_shader4',
  'GL_ARB_texture_rectangle',
  'GL_EXT_frag_depth',
  'GL_EXT_draw_buffers',
  'GL_OES_texture_3D',
]);

interface Branch {
  readonly opened: Token;
  /** Whether the enclosing text is active. */
  readonly outer: boolean;
  taken: boolean;
  active: boolean;
  sawElse: boolean;
}

/**
 * Evaluates all directives of a source and returns plain GLSL tokens with the author's positions.
 *
 * @param defined Further predefined macros.
 * @throws GlslError at the first mistake.
 */
export function preprocess(source: string, defined: Readonly<Record<string, number>> = {}): Token[] {
  const tokens = lex(source);
  const macros: MacroTable = new Map();
  for (const [name, value] of [...Object.entries(PREDEFINED), ...Object.entries(defined)]) macros.set(name, predefined(name, value));
  const budget = createExpansionBudget();
  const branches: Branch[] = [];
  const output: Token[] = [];
  // Text between two directives is expanded together, so that arguments of macros may span lines.
  let text: Token[] = [];

  function flush(): void {
    for (const token of expandMacros(text, macros, budget)) output.push(token);
    text = [];
  }

  let position = 0;
  for (let token = tokens[position]; token !== undefined; token = tokens[position]) {
    position += 1;
    if (token.startsLine && token.text === '#') {
      const start = position;
      while (tokens[position]?.startsLine === false) position += 1;
      flush();
      const line = tokens.slice(start, position);
      if (line.length > 0) carryOut(line, token, branches, macros, budget);
    } else if (token.kind === 'end' || isActive(branches)) {
      text.push(token);
    }
  }
  const open = branches.at(-1);
  if (open !== undefined) throw new GlslError(open.opened, `This "#${open.opened.text}" has no "#endif".`);
  flush();
  return output;
}

function isActive(branches: readonly Branch[]): boolean {
  return branches.at(-1)?.active ?? true;
}

function carryOut(line: readonly Token[], hash: Token, branches: Branch[], macros: MacroTable, budget: ExpansionBudget): void {
  const [directive, ...rest] = line;
  if (directive === undefined) return;
  if (carryOutBranch(directive, rest, branches, macros, budget) || !isActive(branches)) return;
  switch (directive.text) {
    case 'define':
      define(directive, rest, macros);
      return;
    case 'undef':
      macros.delete(macroName(directive, rest).text);
      return;
    case 'extension':
      requireExtension(rest);
      return;
    case 'error':
      throw new GlslError(hash, `The shader contains "#error": ${rest.map((t) => t.text).join(' ')}`);
    case 'version':
    case 'pragma':
    case 'line':
      return;
    case 'include':
      throw new GlslError(hash, 'A shader file is complete in itself: "#include" is not available here.', 'SCR043');
    default:
      throw new GlslError(directive, `"#${directive.text}" is not a directive of GLSL.`);
  }
}

function carryOutBranch(
  directive: Token,
  rest: readonly Token[],
  branches: Branch[],
  macros: MacroTable,
  budget: ExpansionBudget,
): boolean {
  const branch = branches.at(-1);
  switch (directive.text) {
    case 'if':
    case 'ifdef':
    case 'ifndef': {
      const outer = isActive(branches);
      const active = outer && holds(directive, rest, macros, budget);
      branches.push({ opened: directive, outer, taken: active, active, sawElse: false });
      return true;
    }
    case 'elif':
    case 'else':
      if (branch === undefined) throw new GlslError(directive, `This "#${directive.text}" has no "#if".`);
      if (branch.sawElse) throw new GlslError(directive, `This "#${directive.text}" comes after "#else".`);
      branch.sawElse = directive.text === 'else';
      branch.active = branch.outer && !branch.taken && (branch.sawElse || holds(directive, rest, macros, budget));
      branch.taken ||= branch.active;
      return true;
    case 'endif':
      if (branches.pop() === undefined) throw new GlslError(directive, 'This "#endif" has no "#if".');
      return true;
    default:
      return false;
  }
}

function holds(directive: Token, rest: readonly Token[], macros: MacroTable, budget: ExpansionBudget): boolean {
  if (directive.text === 'ifdef') return macros.has(macroName(directive, rest).text);
  if (directive.text === 'ifndef') return !macros.has(macroName(directive, rest).text);
  const known: Token[] = [];
  for (let i = 0; i < rest.length; i += 1) {
    const token = rest[i] as Token;
    if (token.text !== 'defined') {
      known.push(token);
      continue;
    }
    const bracket = rest[i + 1]?.text === '(';
    const name = rest[i + (bracket ? 2 : 1)];
    if (name?.kind !== 'word' || (bracket && rest[i + 3]?.text !== ')')) throw new GlslError(token, '"defined" needs the name of a macro.');
    known.push({ ...name, kind: 'int', text: macros.has(name.text) ? '1' : '0' });
    i += bracket ? 3 : 1;
  }
  return evaluateCondition(expandMacros(known, macros, budget), directive) !== 0;
}

function define(directive: Token, rest: readonly Token[], macros: MacroTable): void {
  const name = macroName(directive, rest);
  const open = rest[1];
  if (open?.text !== '(' || open.spaced) {
    macros.set(name.text, { name: name.text, parameters: null, body: rest.slice(1) });
    return;
  }
  const parameters: string[] = [];
  let position = 2;
  while (rest[position]?.text !== ')') {
    const parameter = rest[position];
    if (parameter?.kind !== 'word')
      throw new GlslError(parameter ?? name, `The parameters of the macro "${name.text}" are not a list of names.`);
    parameters.push(parameter.text);
    position += rest[position + 1]?.text === ',' ? 2 : 1;
  }
  macros.set(name.text, { name: name.text, parameters, body: rest.slice(position + 1) });
}

function macroName(directive: Token, rest: readonly Token[]): Token {
  const [name] = rest;
  if (name?.kind !== 'word') throw new GlslError(name ?? directive, `"#${directive.text}" needs the name of a macro.`);
  return name;
}

function requireExtension(rest: readonly Token[]): void {
  const [name, , behavior] = rest;
  if (name === undefined || behavior?.text !== 'require' || EXTENSIONS_IN_CORE.has(name.text)) return;
  throw new GlslError(name, `The extension ${name.text} is not in WebGL 2, so this shader cannot run.`, 'SCR043');
}

function predefined(name: string, value: number): Macro {
  const token: Token = { kind: 'int', text: String(value), line: 1, column: 1, startsLine: false, spaced: true, hidden: null };
  return { name, parameters: null, body: [token] };
}
