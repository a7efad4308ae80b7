import type { Dimension, Expression, TypeSpecifier } from './ast.ts';
import type { Cursor } from './cursor.ts';
import { GlslError, type Token } from './token.ts';
import { KEYWORDS, TYPES } from './words.ts';

/** Binary operators by precedence (GLSL ES 3.00 §5.1). */
const PRECEDENCE: ReadonlyMap<string, number> = new Map(
  [['||'], ['^^'], ['&&'], ['|'], ['^'], ['&'], ['==', '!='], ['<', '>', '<=', '>='], ['<<', '>>'], ['+', '-'], ['*', '/', '%']].flatMap(
    (operators, level) => operators.map((operator) => [operator, level + 1] as const),
  ),
);

export const ASSIGNMENTS: ReadonlySet<string> = new Set(['=', '+=', '-=', '*=', '/=', '%=', '<<=', '>>=', '&=', '^=', '|=']);

const PREFIXES: ReadonlySet<string> = new Set(['+', '-', '!', '~', '++', '--']);

/** Limits chains such as `a + b + c + …`, whose tree is as deep as they are long. */
const MAX_TREE_DEPTH = 1000;

/** Parses an expression in which commas are operators: `i++, j--`. */
export function parseExpression(cursor: Cursor): Expression {
  let left = parseAssignment(cursor);
  while (cursor.at(',')) left = binary(cursor.next(), left, parseAssignment(cursor));
  return left;
}

/** Parses an expression that ends before a comma, such as an argument or an initializer. */
export function parseAssignment(cursor: Cursor): Expression {
  return cursor.nested(() => {
    const left = parseConditional(cursor);
    if (!ASSIGNMENTS.has(cursor.peek().text)) return left;
    return binary(cursor.next(), left, parseAssignment(cursor));
  });
}

/** Parses the name of a type: `vec3`, or the name of a struct. */
export function parseTypeName(cursor: Cursor): Token {
  const token = cursor.peek();
  if (token.kind !== 'word') throw cursor.unexpected('A type is missing');
  if (KEYWORDS.has(token.text) && !TYPES.has(token.text)) throw new GlslError(token, `"${token.text}" is not a type.`);
  return cursor.next();
}

/** Parses the sizes of an array: `[4]`, `[]`, `[2][3]` or nothing. */
export function parseDimensions(cursor: Cursor): Dimension[] {
  const dimensions: Dimension[] = [];
  while (cursor.accept('[')) {
    dimensions.push(cursor.at(']') ? null : parseAssignment(cursor));
    cursor.expect(']', 'after the size of the array');
  }
  return dimensions;
}

function parseConditional(cursor: Cursor): Expression {
  const condition = parseBinary(cursor, 1);
  const token = cursor.accept('?');
  if (token === null) return condition;
  const then = cursor.nested(() => parseExpression(cursor));
  cursor.expect(':', 'after the first choice of "?"');
  const otherwise = parseAssignment(cursor);
  return { kind: 'conditional', token, condition, then, otherwise, ...made(token, condition, then, otherwise) };
}

function parseBinary(cursor: Cursor, minimum: number): Expression {
  let left = parseUnary(cursor);
  for (;;) {
    const token = cursor.peek();
    const precedence = token.kind === 'operator' ? (PRECEDENCE.get(token.text) ?? 0) : 0;
    if (precedence < minimum) return left;
    left = binary(cursor.next(), left, parseBinary(cursor, precedence + 1));
  }
}

function parseUnary(cursor: Cursor): Expression {
  if (!PREFIXES.has(cursor.peek().text) || cursor.peek().kind !== 'operator') return parsePostfix(cursor);
  const token = cursor.next();
  const operand = cursor.nested(() => parseUnary(cursor));
  return { kind: 'prefix', token, operand, ...made(token, operand) };
}

function parsePostfix(cursor: Cursor): Expression {
  let object = parsePrimary(cursor);
  for (;;) {
    const token = cursor.peek();
    if (cursor.accept('[')) {
      const index = cursor.nested(() => parseExpression(cursor));
      cursor.expect(']', 'after the index');
      object = { kind: 'index', token, object, index, ...made(token, object, index) };
    } else if (cursor.accept('.')) {
      const name = cursor.peek();
      if (name.kind !== 'word') throw cursor.unexpected('The name of a component or member is missing after "."');
      cursor.next();
      if (name.text === 'length' && cursor.accept('(')) {
        cursor.expect(')', 'after "length("');
        object = { kind: 'length', token: name, object, ...made(name, object) };
      } else {
        object = { kind: 'member', token: name, object, name, ...made(name, object) };
      }
    } else if (token.kind === 'operator' && (token.text === '++' || token.text === '--')) {
      cursor.next();
      object = { kind: 'postfix', token, operand: object, ...made(token, object) };
    } else {
      return object;
    }
  }
}

function parsePrimary(cursor: Cursor): Expression {
  const token = cursor.peek();
  switch (token.kind) {
    case 'int':
    case 'uint':
    case 'float':
      cursor.next();
      return { kind: 'literal', token, ...made(token), type: token.kind };
    case 'word':
      return parseWord(cursor, token);
    default:
  }
  if (cursor.accept('(')) {
    const inner = cursor.nested(() => parseExpression(cursor));
    const close = cursor.expect(')', `to close the bracket of line ${token.line}`);
    return { kind: 'group', token, inner, close, ...made(token, inner) };
  }
  throw cursor.unexpected('A value is missing');
}

function parseWord(cursor: Cursor, token: Token): Expression {
  if (token.text === 'true' || token.text === 'false') {
    cursor.next();
    return { kind: 'literal', token, ...made(token), type: 'bool' };
  }
  if (isArrayConstructor(cursor)) {
    const of: TypeSpecifier = { name: parseTypeName(cursor), dimensions: parseDimensions(cursor), struct: null, type: '', symbol: null };
    const args = parseArguments(cursor);
    return { kind: 'array', token, of, args, ...made(token, ...args) };
  }
  const called = cursor.peek(1).text === '(';
  if (KEYWORDS.has(token.text) && !(called && TYPES.has(token.text))) {
    throw new GlslError(token, `"${token.text}" cannot stand here: a value is expected.`);
  }
  cursor.next();
  if (!called) return { kind: 'name', token, symbol: null, ...made(token) };
  const args = parseArguments(cursor);
  return { kind: 'call', token, args, symbol: null, ...made(token, ...args) };
}

/** Creates a constructor call such as `float[3](…)` or `vec2(…)`, for other notations of the same value. */
export function constructorOf(of: TypeSpecifier, args: readonly Expression[]): Expression {
  const token = of.name;
  if (of.dimensions.length > 0) return { kind: 'array', token, of, args, ...made(token, ...args) };
  return { kind: 'call', token, args, symbol: null, ...made(token, ...args) };
}

function parseArguments(cursor: Cursor): Expression[] {
  const open = cursor.expect('(', 'before the arguments');
  const args: Expression[] = [];
  if (cursor.at('void') && cursor.peek(1).text === ')') cursor.next();
  while (!cursor.accept(')')) {
    if (args.length > 0) cursor.expect(',', `or ")" to go on with the arguments of line ${open.line}`);
    args.push(parseAssignment(cursor));
  }
  return args;
}

/**
 * Whether an array constructor is at the cursor: `float[3](` or `float[](`, a type with a size and an opening bracket. It cannot be an
 * indexed value, because those are never called.
 */
function isArrayConstructor(cursor: Cursor): boolean {
  if (cursor.peek(1).text !== '[') return false;
  let depth = 0;
  for (let ahead = 1; ; ahead += 1) {
    const token = cursor.peek(ahead);
    if (token.kind === 'end' || token.text === ';') return false;
    if (token.text === '[') depth += 1;
    if (token.text === ']') depth -= 1;
    if (depth === 0) return cursor.peek(ahead + 1).text === '(' || (cursor.peek(ahead + 1).text === '[' && TYPES.has(cursor.peek().text));
  }
}

function binary(token: Token, left: Expression, right: Expression): Expression {
  return { kind: 'binary', token, left, right, ...made(token, left, right) };
}

/** The common properties of expressions; throws if the tree becomes too deep. */
function made(token: Token, ...parts: readonly Expression[]): { type: ''; convertTo: ''; depth: number } {
  let depth = 1;
  for (const part of parts) depth = Math.max(depth, part.depth + 1);
  if (depth > MAX_TREE_DEPTH) throw new GlslError(token, 'This expression is too long or nested too deeply.');
  return { type: '', convertTo: '', depth };
}
