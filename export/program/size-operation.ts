/** How many numbers each operation takes; it leaves one. */
const TAKES = {
  '+': 2,
  '-': 2,
  '*': 2,
  '/': 2,
  '%': 2,
  '^': 2,
  '<': 2,
  '<=': 2,
  '==': 2,
  '&&': 2,
  '||': 2,
  '!': 1,
  '?:': 3,
  negate: 1,
  floor: 1,
  ceil: 1,
  min: 2,
  max: 2,
  abs: 1,
  round: 1,
  sqrt: 1,
  log2: 1,
} as const;

/** An operation of a size expression, on numbers that stand before it; `!` and comparisons leave 1 or 0. */
export type SizeOperation = keyof typeof TAKES;

/** Places that lie empty below the first number of a stack, so that no operation looks for one outside of it. */
export const SIZE_STACK_BOTTOM = 3;

/** Writes what a name in a size expression stands for into the stack: a fraction handed back would be a heap object. */
export type PutNamed<Name, Values> = (name: Name, values: Values, stack: Float64Array, at: number) => void;

/**
 * Plays a size expression, which is postfix. The last number is then at `SIZE_STACK_BOTTOM` of the stack; false where the expression
 * leaves none or several. `stack`: longer than the expression by `SIZE_STACK_BOTTOM`.
 */
export function runSize<Name extends object, Values>(
  expression: readonly (number | { readonly op: 'width' | 'height' | SizeOperation } | Name)[],
  width: number,
  height: number,
  put: PutNamed<Name, Values>,
  values: Values,
  stack: Float64Array,
): boolean {
  let top = SIZE_STACK_BOTTOM - 1;
  for (let i = 0; i < expression.length; i++) {
    const token = expression[i];
    if (token === undefined) break;
    if (typeof token === 'number') stack[++top] = token;
    else if (!('op' in token)) put(token, values, stack, ++top);
    else if (token.op === 'width') stack[++top] = width;
    else if (token.op === 'height') stack[++top] = height;
    else top = applySizeOperation(token.op, stack, top);
  }
  return top === SIZE_STACK_BOTTOM;
}

/** Does an operation with the numbers at the top of the stack, and leaves what comes out in their place: the new top. */
function applySizeOperation(op: SizeOperation, stack: Float64Array, top: number): number {
  const at = top + 1 - TAKES[op];
  const a = stack[at] ?? 0;
  const b = stack[at + 1] ?? 0;
  const c = stack[at + 2] ?? 0;
  switch (op) {
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
      stack[at] = a % b;
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
    case '==':
      stack[at] = a === b ? 1 : 0;
      break;
    case '&&':
      stack[at] = a && b ? 1 : 0;
      break;
    case '||':
      stack[at] = a || b ? 1 : 0;
      break;
    case '!':
      stack[at] = a ? 0 : 1;
      break;
    case '?:':
      stack[at] = a ? b : c;
      break;
    case 'negate':
      stack[at] = -a;
      break;
    case 'floor':
      stack[at] = Math.floor(a);
      break;
    case 'ceil':
      stack[at] = Math.ceil(a);
      break;
    case 'min':
      stack[at] = Math.min(a, b);
      break;
    case 'max':
      stack[at] = Math.max(a, b);
      break;
    case 'abs':
      stack[at] = Math.abs(a);
      break;
    case 'round':
      stack[at] = Math.round(a);
      break;
    case 'sqrt':
      stack[at] = Math.sqrt(a);
      break;
    case 'log2':
      stack[at] = Math.log2(a);
      break;
    default:
      exhaustive(op);
  }
  return at;
}

function exhaustive(op: never): never {
  throw new Error(`Unknown size operation ${String(op)}.`);
}
