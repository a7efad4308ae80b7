import { calleesFirst, functionsOf } from '../check/call-graph.ts';
import type { CheckedShader } from '../check/check-shader.ts';
import { numericOf } from '../check/glsl-type.ts';
import { classifyImageCall, isTableRead } from '../link/image-call.ts';
import type { CallExpression, Expression, FunctionSymbol, Statement } from '../syntax/ast.ts';
import { takenParts } from './taken-parts.ts';

/** Operations per component of a built-in function, in those of GPUs; others are one. Sines, roots and logarithms run at a quarter of the rate. */
const WEIGHTS: Readonly<Record<string, number>> = Object.fromEntries(
  Object.entries({
    2: 'clamp dot step sign fract faceforward',
    3: 'mix cross',
    4: 'sin cos exp log exp2 log2 sqrt inversesqrt',
    6: 'mod reflect length distance normalize',
    8: 'tan smoothstep',
    9: 'pow',
    16: 'asin acos atan sinh cosh tanh asinh acosh atanh refract',
    32: 'inverse determinant',
  }).flatMap(([weight, names]) => names.split(' ').map((name) => [name, Number(weight)])),
);

const DIVISION = 4;

/** A curve or a gradient is read from a texture of one row. */
const TABLE_READ = 16;

/**
 * Estimates the arithmetic operations of a pass per pixel, without its reads of images: operators and built-in functions, by components.
 * Branches that are not taken count too; infinite if there is a loop.
 */
export function countOperations({ main, declarations }: CheckedShader, passIndex: number): number {
  const known = new Map<FunctionSymbol, number>();

  function ofPart(part: Statement | Expression): number {
    if (part.kind === 'for' || part.kind === 'while' || part.kind === 'do') return Number.POSITIVE_INFINITY;
    return takenParts(part, passIndex).reduce((sum, inner) => sum + ofPart(inner), ownOperations(part, known));
  }

  for (const symbol of calleesFirst(functionsOf(declarations))) {
    const { body } = symbol.declaration;
    known.set(symbol, body === null ? 0 : ofPart(body));
  }
  return main.symbol === null ? Number.POSITIVE_INFINITY : (known.get(main.symbol) ?? Number.POSITIVE_INFINITY);
}

function ownOperations(part: Statement | Expression, known: ReadonlyMap<FunctionSymbol, number>): number {
  switch (part.kind) {
    case 'binary':
      return ofOperator(part);
    case 'conditional':
      return components(part);
    case 'call':
      return ofCall(part, known);
    default:
      return 0;
  }
}

function ofOperator({ token, left, right }: Extract<Expression, { kind: 'binary' }>): number {
  if (token.text === '=' || token.text === ',') return 0;
  const size = Math.max(components(left), components(right));
  const isMatrix = [left, right].some(({ type }) => (numericOf(type)?.columns ?? 1) > 1);
  if (isMatrix) return 2 * size;
  return token.text.startsWith('/') ? DIVISION * size : size;
}

function ofCall(call: CallExpression, known: ReadonlyMap<FunctionSymbol, number>): number {
  if (call.symbol?.kind === 'function') return known.get(call.symbol) ?? Number.POSITIVE_INFINITY;
  const read = classifyImageCall(call);
  if (read !== null) return isTableRead(read) ? TABLE_READ : 0;
  const name = call.token.text;
  if (call.symbol !== null || numericOf(name) !== null) return 0;
  return (WEIGHTS[name] ?? 1) * Math.max(1, ...call.args.map(components));
}

function components({ type }: Pick<Expression, 'type'>): number {
  const numeric = numericOf(type);
  return numeric === null ? 1 : numeric.rows * numeric.columns;
}
