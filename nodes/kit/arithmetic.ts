/** The number of operands of each operation; each has one result. */
export const ARITHMETIC = {
  negate: 1,
  '!': 1,
  sqrt: 1,
  log2: 1,
  abs: 1,
  floor: 1,
  ceil: 1,
  round: 1,
  '+': 2,
  '-': 2,
  '*': 2,
  '/': 2,
  '%': 2,
  '^': 2,
  '<': 2,
  '<=': 2,
  '>': 2,
  '>=': 2,
  '==': 2,
  '!=': 2,
  '&&': 2,
  '||': 2,
  min: 2,
  max: 2,
  '?:': 3,
} as const;

/** The name of an operation in expressions of params and in size expressions of shaders. `log2` occurs only in the latter. */
export type ArithmeticOperation = keyof typeof ARITHMETIC;

/**
 * Applies an operation to the numbers of a stack from `at` on, and writes the result to `at`. A comparison and `!` give 1 or 0; `%` has
 * the sign of the divisor. It returns nothing, because JavaScript engines allocate a heap object for a fraction that a function returns.
 *
 * @param at Index of the first operand; the others follow it.
 *
 * @example
 * const stack = Float64Array.of(-7, 3);
 * calculate('%', stack, 0); // stack[0] is 2
 */
export function calculate(operation: ArithmeticOperation, stack: Float64Array, at: number): void {
  const a = stack[at] ?? 0;
  const b = stack[at + 1] ?? 0;
  const c = stack[at + 2] ?? 0;
  switch (operation) {
    case 'negate':
      stack[at] = -a;
      break;
    case '!':
      stack[at] = a ? 0 : 1;
      break;
    case 'sqrt':
      stack[at] = Math.sqrt(a);
      break;
    case 'log2':
      stack[at] = Math.log2(a);
      break;
    case 'abs':
      stack[at] = Math.abs(a);
      break;
    case 'floor':
      stack[at] = Math.floor(a);
      break;
    case 'ceil':
      stack[at] = Math.ceil(a);
      break;
    case 'round':
      stack[at] = Math.round(a);
      break;
    case '+':
      stack[at] = a + b;
      break;
    case '-':
      stack[at] = a - b;
      break;
    case '*':
      stack[at] = a * b;
      break;
    case '/':
      stack[at] = a / b;
      break;
    case '%':
      stack[at] = a - b * Math.floor(a / b);
      break;
    case '^':
      stack[at] = a ** b;
      break;
    case '<':
      stack[at] = a < b ? 1 : 0;
      break;
    case '<=':
      stack[at] = a <= b ? 1 : 0;
      break;
    case '>':
      stack[at] = a > b ? 1 : 0;
      break;
    case '>=':
      stack[at] = a >= b ? 1 : 0;
      break;
    case '==':
      stack[at] = a === b ? 1 : 0;
      break;
    case '!=':
      stack[at] = a !== b ? 1 : 0;
      break;
    case '&&':
      stack[at] = a && b ? 1 : 0;
      break;
    case '||':
      stack[at] = a || b ? 1 : 0;
      break;
    case 'min':
      stack[at] = Math.min(a, b);
      break;
    case 'max':
      stack[at] = Math.max(a, b);
      break;
    case '?:':
      stack[at] = a ? b : c;
      break;
    default:
      exhaustive(operation);
  }
}

function exhaustive(operation: never): never {
  throw new Error(`Unknown operation ${String(operation)}.`);
}
