import { GlslError, type Token } from './token.ts';

/** Binary operators by precedence, from the lowest to the highest (GLSL ES 3.00 §3.4). */
const LEVELS: readonly (readonly string[])[] = [
  ['||'],
  ['&&'],
  ['|'],
  ['^'],
  ['&'],
  ['==', '!='],
  ['<', '>', '<=', '>='],
  ['<<', '>>'],
  ['+', '-'],
  ['*', '/', '%'],
];

const MAX_DEPTH = 100;

/**
 * Evaluates an `#if` or `#elif` expression in which macros and `defined` are already replaced. An undefined name is 0, as on most desktop
 * drivers; GLSL ES makes it an error, but published files rely on it.
 */
export function evaluateCondition(tokens: readonly Token[], directive: Token): number {
  let position = 0;

  function peek(): Token | undefined {
    return tokens[position];
  }

  function binary(level: number, depth: number): number {
    const operators = LEVELS[level];
    if (operators === undefined) return unary(depth);
    let left = binary(level + 1, depth);
    for (let token = peek(); token !== undefined && operators.includes(token.text); token = peek()) {
      position += 1;
      left = apply(token, left, binary(level + 1, depth));
    }
    return left;
  }

  function unary(depth: number): number {
    const token = peek();
    if (token === undefined) throw new GlslError(tokens.at(-1) ?? directive, `The condition of "#${directive.text}" is not complete.`);
    if (depth > MAX_DEPTH) throw new GlslError(token, 'This condition is nested too deeply.');
    position += 1;
    if (token.text === '!') return unary(depth + 1) === 0 ? 1 : 0;
    if (token.text === '-') return -unary(depth + 1) | 0;
    if (token.text === '+') return unary(depth + 1);
    if (token.text === '~') return ~unary(depth + 1);
    if (token.text === '(') {
      const value = binary(0, depth + 1);
      if (peek()?.text !== ')') throw new GlslError(peek() ?? token, 'A closing bracket is missing in this condition.');
      position += 1;
      return value;
    }
    if (token.kind === 'int' || token.kind === 'uint') return integerValue(token.text);
    if (token.kind === 'word') return 0;
    throw new GlslError(token, `"${token.text}" is not allowed in a condition. Use whole numbers, macros and operators.`);
  }

  const value = binary(0, 0);
  const rest = peek();
  if (rest !== undefined) throw new GlslError(rest, `"${rest.text}" is not expected here in the condition.`);
  return value;
}

/** The value of a decimal, octal (with a leading 0) or hexadecimal integer, as a 32-bit number. */
function integerValue(text: string): number {
  const digits = text.replace(/[uU]$/, '');
  if (/^0[0-7]+$/.test(digits)) return Number.parseInt(digits, 8) | 0;
  return Number(digits) | 0;
}

function apply(operator: Token, a: number, b: number): number {
  switch (operator.text) {
    case '||':
      return a !== 0 || b !== 0 ? 1 : 0;
    case '&&':
      return a !== 0 && b !== 0 ? 1 : 0;
    case '|':
      return a | b;
    case '^':
      return a ^ b;
    case '&':
      return a & b;
    case '==':
      return a === b ? 1 : 0;
    case '!=':
      return a !== b ? 1 : 0;
    case '<':
      return a < b ? 1 : 0;
    case '>':
      return a > b ? 1 : 0;
    case '<=':
      return a <= b ? 1 : 0;
    case '>=':
      return a >= b ? 1 : 0;
    case '<<':
      return a << b;
    case '>>':
      return a >> b;
    case '+':
      return (a + b) | 0;
    case '-':
      return (a - b) | 0;
    case '*':
      return Math.imul(a, b);
    default:
      if (b === 0) throw new GlslError(operator, 'This condition divides by zero.');
      return (operator.text === '/' ? a / b : a % b) | 0;
  }
}
