import type { NamedSize } from './isf-shader.ts';

export interface SizeProblem {
  /** Offset within the expression, from 0. */
  readonly offset: number;
  readonly message: string;
}

type SizeOp = Extract<NamedSize[number], { op: string }>['op'];

interface SizeFunction {
  /** Number of operands. */
  readonly takes: number;
  /** Operations to apply in order. */
  readonly does: readonly SizeOp[];
}

const FUNCTIONS: ReadonlyMap<string, SizeFunction> = new Map([
  ['floor', { takes: 1, does: ['floor'] }],
  ['ceil', { takes: 1, does: ['ceil'] }],
  ['round', { takes: 1, does: ['round'] }],
  ['abs', { takes: 1, does: ['abs'] }],
  ['sqrt', { takes: 1, does: ['sqrt'] }],
  ['log2', { takes: 1, does: ['log2'] }],
  ['min', { takes: 2, does: ['min'] }],
  ['max', { takes: 2, does: ['max'] }],
  ['mod', { takes: 2, does: ['%'] }],
  ['pow', { takes: 2, does: ['^'] }],
]);

const POWER = 8;

/** Binary operators with precedence and operations; powers associate from right to left, the others from left to right. */
const SIGNS: ReadonlyMap<string, { readonly binds: number; readonly does: readonly SizeOp[] }> = new Map([
  ['||', { binds: 1, does: ['||'] }],
  ['&&', { binds: 2, does: ['&&'] }],
  ['==', { binds: 3, does: ['=='] }],
  ['!=', { binds: 3, does: ['==', '!'] }],
  ['<', { binds: 4, does: ['<'] }],
  ['<=', { binds: 4, does: ['<='] }],
  ['>', { binds: 4, does: ['<=', '!'] }],
  ['>=', { binds: 4, does: ['<', '!'] }],
  ['+', { binds: 5, does: ['+'] }],
  ['-', { binds: 5, does: ['-'] }],
  ['*', { binds: 6, does: ['*'] }],
  ['/', { binds: 6, does: ['/'] }],
  ['%', { binds: 6, does: ['%'] }],
  ['^', { binds: POWER, does: ['^'] }],
]);

/** Precedence of unary signs: below powers, so that `-2 ^ 2` is -4. */
const BEFORE = POWER - 1;

const TOKEN =
  /\s+|(?<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|\$(?<name>[A-Za-z_][A-Za-z0-9_]*)|(?<word>[A-Za-z_][A-Za-z0-9_]*)|(?<sign>[<>=!]=|&&|\|\||[-+*/%^(),<>!?:])/gy;

/** Maximum length, which limits the stack. */
const MAX_LENGTH = 500;

interface Lexeme {
  readonly kind: 'number' | 'name' | 'word' | 'sign' | 'end';
  readonly text: string;
  readonly offset: number;
}

/**
 * Parses an ISF size expression such as `floor(max($WIDTH * 0.25, 1.0))`: numbers, `$WIDTH` and `$HEIGHT` of the layer, other `$inputs`,
 * the operators of C and `^` for powers, `? :`, brackets and the functions above. The specification has no grammar; hosts use arithmetic
 * libraries.
 */
export function parseSizeExpression(text: string, isParam: (name: string) => boolean): NamedSize | SizeProblem {
  try {
    return parse(lexSize(text), isParam);
  } catch (fault) {
    if (fault instanceof SizeFault) return { offset: fault.offset, message: fault.message };
    throw fault;
  }
}

export function isSizeProblem(result: NamedSize | SizeProblem): result is SizeProblem {
  return 'message' in result;
}

class SizeFault extends Error {
  readonly offset: number;

  constructor(offset: number, message: string) {
    super(message);
    this.offset = offset;
  }
}

function parse(lexemes: readonly Lexeme[], isParam: (name: string) => boolean): NamedSize {
  const output: NamedSize[number][] = [];
  let position = 0;

  function peek(): Lexeme {
    return lexemes[position] as Lexeme;
  }

  function accept(sign: string): boolean {
    if (peek().kind !== 'sign' || peek().text !== sign) return false;
    position += 1;
    return true;
  }

  function fail(message: string): never {
    throw new SizeFault(peek().offset, message);
  }

  function apply(operations: readonly SizeOp[]): void {
    for (const op of operations) output.push({ op });
  }

  /** Parses a complete expression with `? :`, which has the lowest precedence and associates from right to left. */
  function value(): void {
    operation(0);
    if (!accept('?')) return;
    value();
    if (!accept(':')) fail('Expected “:” after “?” in the size.');
    value();
    apply(['?:']);
  }

  /** Parses operators with at least the precedence `least`. */
  function operation(least: number): void {
    factor();
    for (;;) {
      const sign = peek().kind === 'sign' ? SIGNS.get(peek().text) : undefined;
      if (sign === undefined || sign.binds <= least) return;
      position += 1;
      operation(sign.binds === POWER ? POWER - 1 : sign.binds);
      apply(sign.does);
    }
  }

  function factor(): void {
    const lexeme = peek();
    if (accept('-')) {
      operation(BEFORE);
      apply(['negate']);
    } else if (accept('!')) {
      operation(BEFORE);
      apply(['!']);
    } else if (accept('+')) {
      operation(BEFORE);
    } else if (accept('(')) {
      value();
      if (!accept(')')) fail('Expected “)” in the size.');
    } else if (lexeme.kind === 'number') {
      position += 1;
      output.push(Number(lexeme.text));
    } else if (lexeme.kind === 'name') {
      variable(lexeme);
    } else if (lexeme.kind === 'word') {
      call(lexeme);
    } else {
      fail(lexeme.kind === 'end' ? 'The size is not complete.' : `"${lexeme.text}" is not expected here in the size.`);
    }
  }

  function variable(lexeme: Lexeme): void {
    if (lexeme.text === 'WIDTH') output.push({ op: 'width' });
    else if (lexeme.text === 'HEIGHT') output.push({ op: 'height' });
    else if (isParam(lexeme.text)) output.push({ param: lexeme.text });
    else fail(`"$${lexeme.text}" is neither $WIDTH, $HEIGHT nor an input that is a number.`);
    position += 1;
  }

  function call(lexeme: Lexeme): void {
    const called = FUNCTIONS.get(lexeme.text);
    if (called === undefined) fail(`“${lexeme.text}” is unknown in a size. Use ${[...FUNCTIONS.keys()].join(', ')} or a $input.`);
    position += 1;
    if (!accept('(')) fail(`Expected “(” after “${lexeme.text}”.`);
    value();
    for (let i = 1; i < called.takes; i += 1) {
      if (!accept(',')) fail(`"${lexeme.text}" takes ${called.takes} values in a size.`);
      value();
    }
    if (!accept(')')) fail(`Expected “)” after the values of “${lexeme.text}”.`);
    apply(called.does);
  }

  value();
  if (peek().kind !== 'end') fail(`"${peek().text}" is not expected here in the size.`);
  return output;
}

function lexSize(text: string): Lexeme[] {
  if (text.length > MAX_LENGTH) throw new SizeFault(0, `The size is longer than ${MAX_LENGTH} characters.`);
  const lexemes: Lexeme[] = [];
  const pattern = new RegExp(TOKEN);
  let offset = 0;
  while (offset < text.length) {
    pattern.lastIndex = offset;
    const match = pattern.exec(text);
    if (match === null) throw new SizeFault(offset, `"${text[offset]}" is not expected here in the size.`);
    for (const kind of ['number', 'name', 'word', 'sign'] as const) {
      const found = match.groups?.[kind];
      if (found !== undefined) lexemes.push({ kind, text: found, offset });
    }
    offset += match[0].length;
  }
  lexemes.push({ kind: 'end', text: '', offset });
  return lexemes;
}
