import type { Dimension, Expression, TypeSpecifier } from './ast.ts';
import type { Cursor } from './cursor.ts';
import { GlslError, type Token } from './token.ts';
import { KEYWORDS, TYPES } from './words.ts';

/** Binary operators by how tightly they bind (GLSL ES 3.00 §5.1). */
const PRECEDENCE: ReadonlyMap<string, number> = new Map(
  [['||'], ['^^'], ['&&'], ['|'], ['^'], ['&'], ['==', '!='], ['<', '>', '<=', '>='], ['<<', '>>'], ['+', '-'], ['*', '/', '%']].flatMap(
    (operators, level) => operators.map((operator) => [operator, level + 1] as const),
  ),
);

export const ASSIGNMENTS: ReadonlySet<string> = new Set(['=', '+=', '-=', '*=', '/=', '%=', '<<=', '>>=', '&=', '^=', '|=']);

const PREFIXES: ReadonlySet<string> = new Set(['+', '-', '!', '~', '++', '--']);

/** Links of one chain such as `a + b + c + …`, which makes a tree as deep as it is long. */
const MAX_CHAIN = 1000;

/** With commas: `i++, j--`. */
export function parseExpression(cursor: Cursor): Expression {
  let left = parseAssignment(cursor);
  for (let links = 0; cursor.at(','); links += 1) {
    const token = cursor.next();
    checkChain(links, token);
    left = { kind: 'binary', token, left, right: parseAssignment(cursor), type: '', convertTo: '' };
  }
  return left;
}

/** Without commas: an argument or an initialiser. */
export function parseAssignment(cursor: Cursor): Expression {
  return cursor.nested(() => {
    const left = parseConditional(cursor);
    if (!ASSIGNMENTS.has(cursor.peek().text)) return left;
    const token = cursor.next();
    return { kind: 'binary', token, left, right: parseAssignment(cursor), type: '', convertTo: '' };
  });
}

/** A type's own name: `vec3`, or that of a struct. */
export function parseTypeName(cursor: Cursor): Token {
  const token = cursor.peek();
  if (token.kind !== 'word') throw cursor.unexpected('A type is missing');
  if (KEYWORDS.has(token.text) && !TYPES.has(token.text)) throw new GlslError(token, `"${token.text}" is not a type.`);
  return cursor.next();
}

/** `[4]`, `[]`, `[2][3]` or nothing. */
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
  return { kind: 'conditional', token, condition, then, otherwise: parseAssignment(cursor), type: '', convertTo: '' };
}

function parseBinary(cursor: Cursor, minimum: number): Expression {
  let left = parseUnary(cursor);
  for (let links = 0; ; links += 1) {
    const token = cursor.peek();
    const precedence = token.kind === 'operator' ? (PRECEDENCE.get(token.text) ?? 0) : 0;
    if (precedence < minimum) return left;
    checkChain(links, token);
    cursor.next();
    left = { kind: 'binary', token, left, right: parseBinary(cursor, precedence + 1), type: '', convertTo: '' };
  }
}

function parseUnary(cursor: Cursor): Expression {
  if (!PREFIXES.has(cursor.peek().text) || cursor.peek().kind !== 'operator') return parsePostfix(cursor);
  const token = cursor.next();
  return cursor.nested(() => ({ kind: 'prefix', token, operand: parseUnary(cursor), type: '', convertTo: '' }));
}

function parsePostfix(cursor: Cursor): Expression {
  let object = parsePrimary(cursor);
  for (let links = 0; ; links += 1) {
    const token = cursor.peek();
    checkChain(links, token);
    if (cursor.accept('[')) {
      const index = cursor.nested(() => parseExpression(cursor));
      cursor.expect(']', 'after the index');
      object = { kind: 'index', token, object, index, type: '', convertTo: '' };
    } else if (cursor.accept('.')) {
      const name = cursor.peek();
      if (name.kind !== 'word') throw cursor.unexpected('The name of a component or member is missing after "."');
      cursor.next();
      if (name.text === 'length' && cursor.accept('(')) {
        cursor.expect(')', 'after "length("');
        object = { kind: 'length', token: name, object, type: 'int', convertTo: '' };
      } else {
        object = { kind: 'member', token: name, object, name, type: '', convertTo: '' };
      }
    } else if (token.kind === 'operator' && (token.text === '++' || token.text === '--')) {
      cursor.next();
      object = { kind: 'postfix', token, operand: object, type: '', convertTo: '' };
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
      return { kind: 'literal', token, type: token.kind, convertTo: '' };
    case 'word':
      return parseWord(cursor, token);
    default:
  }
  if (cursor.accept('(')) {
    const inner = cursor.nested(() => parseExpression(cursor));
    const close = cursor.expect(')', `to close the bracket of line ${token.line}`);
    return { kind: 'group', token, inner, close, type: '', convertTo: '' };
  }
  throw cursor.unexpected('A value is missing');
}

function parseWord(cursor: Cursor, token: Token): Expression {
  if (token.text === 'true' || token.text === 'false') {
    cursor.next();
    return { kind: 'literal', token, type: 'bool', convertTo: '' };
  }
  if (isArrayConstructor(cursor)) {
    const of: TypeSpecifier = { name: parseTypeName(cursor), dimensions: parseDimensions(cursor), struct: null, type: '', symbol: null };
    return { kind: 'array', token, of, args: parseArguments(cursor), type: '', convertTo: '' };
  }
  const called = cursor.peek(1).text === '(';
  if (KEYWORDS.has(token.text) && !(called && TYPES.has(token.text))) {
    throw new GlslError(token, `"${token.text}" cannot stand here: a value is expected.`);
  }
  cursor.next();
  if (!called) return { kind: 'name', token, symbol: null, type: '', convertTo: '' };
  return { kind: 'call', token, args: parseArguments(cursor), symbol: null, type: '', convertTo: '' };
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

/** `float[3](` or `float[](`: a type, a size, and an opening bracket. An indexed value is never called. */
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

function checkChain(links: number, token: Token): void {
  if (links > MAX_CHAIN) throw new GlslError(token, 'This expression is too long.');
}
