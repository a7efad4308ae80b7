import { ARITHMETIC, type ArithmeticOperation, calculate } from './arithmetic.ts';

/**
 * Index of the first number of a stack. The entries below it are unused, so that an operation that lacks its operands still reads inside
 * the stack.
 */
export const SIZE_STACK_BOTTOM = 3;

/**
 * A function that writes the value of a name into the stack. It does not return the value, because JavaScript engines allocate a heap
 * object for a fraction that a function returns.
 */
export type PutNamed<Name, Values> = (name: Name, values: Values, stack: Float64Array, at: number) => void;

/**
 * Evaluates a size expression in postfix; the result is then at `SIZE_STACK_BOTTOM` of the stack.
 *
 * @param width The value of `$WIDTH`, pixels.
 * @param height The value of `$HEIGHT`, pixels.
 * @param put Writes the value of a name, from `values`.
 * @param stack Longer than the expression by `SIZE_STACK_BOTTOM`.
 * @returns False if the expression gives no number or several.
 *
 * @example
 * const stack = new Float64Array(SIZE_STACK_BOTTOM + 3);
 * playSize([{ op: 'width' }, 2, { op: '/' }], 640, 360, put, values, stack); // true; stack[SIZE_STACK_BOTTOM] is 320
 */
export function playSize<Name extends object, Values>(
  expression: readonly (number | { readonly op: 'width' | 'height' | ArithmeticOperation } | Name)[],
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
    else {
      top += 1 - ARITHMETIC[token.op];
      calculate(token.op, stack, top);
    }
  }
  return top === SIZE_STACK_BOTTOM;
}
