import type { NamedSize } from './isf-shader.ts';

export interface SizeProblem {
  /** From 0, within the expression. */
  readonly offset: number;
  readonly message: string;
}

/** With how many values each takes. */
const FUNCTIONS: ReadonlyMap<string, number> = new Map([
  ['floor', 1],
  ['ceil', 1],
  ['round', 1],
  ['abs', 1],
  ['sqrt', 1],
  ['min', 2],
  ['max', 2],
]);

const TOKEN =
  /\s+|(?<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|\$(?<name>[A-Za-z_][A-Za-z0-9_]*)|(?<word>[A-Za-z_][A-Za-z0-9_]*)|(?<sign>[-+*/%(),])/gy;

/** Bounds the stack, whatever text comes in. */
const MAX_LENGTH = 500;

type SizeOp = Extract<NamedSize[number], { op: string }>['op'];

interface Lexeme {
  readonly kind: 'number' | 'name' | 'word' | 'sign' | 'end';
  readonly text: string;
  readonly offset: number;
}

/**
 * Reads an ISF size expression such as `floor(max($WIDTH * 0.25, 1.0))`: numbers, `$WIDTH` and `$HEIGHT` of the layer, other
 * `$inputs`, `+ - * / %`, brackets and `floor ceil round abs sqrt min max`.
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

  function sum(): void {
    product();
    for (let sign = peek().text; accept('+') || accept('-'); sign = peek().text) {
      product();
      output.push({ op: sign as '+' | '-' });
    }
  }

  function product(): void {
    factor();
    for (let sign = peek().text; accept('*') || accept('/') || accept('%'); sign = peek().text) {
      factor();
      output.push({ op: sign as '*' | '/' | '%' });
    }
  }

  function factor(): void {
    const lexeme = peek();
    if (accept('-')) {
      factor();
      output.push({ op: 'negate' });
    } else if (accept('+')) {
      factor();
    } else if (accept('(')) {
      sum();
      if (!accept(')')) fail('A ")" is missing in the size.');
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
    const parameters = FUNCTIONS.get(lexeme.text) ?? 0;
    if (parameters === 0) fail(`"${lexeme.text}" is not known in a size: use ${[...FUNCTIONS.keys()].join(', ')} or a $input.`);
    position += 1;
    if (!accept('(')) fail(`A "(" is missing after "${lexeme.text}".`);
    sum();
    for (let i = 1; i < parameters; i += 1) {
      if (!accept(',')) fail(`"${lexeme.text}" takes ${parameters} values in a size.`);
      sum();
    }
    if (!accept(')')) fail(`A ")" is missing after the values of "${lexeme.text}".`);
    output.push({ op: lexeme.text as SizeOp });
  }

  sum();
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
