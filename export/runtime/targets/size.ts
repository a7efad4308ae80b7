import type { SizeExpression } from '../../program/program.ts';
import { applySizeOperation, SIZE_STACK_BOTTOM } from '../../program/size-operation.ts';
import type { Slots } from '../values/slots.ts';

/** More than an expression of the 500 characters that the compiler takes can need. */
const STACK = 512;

/** Reused by every evaluation: an evaluation never starts another one. */
const scratchStack = new Float64Array(STACK);

/** Whole pixels, at least one, at most `maxPx`; a size that is not a number is one pixel. */
export function evaluateSize(expression: SizeExpression, baseWidthPx: number, baseHeightPx: number, slots: Slots, maxPx: number): number {
  const value = evaluate(expression, baseWidthPx, baseHeightPx, slots) ? (scratchStack[SIZE_STACK_BOTTOM] ?? 1) : 1;
  if (Number.isNaN(value)) return 1;
  // The margin takes back what 0.57 * 100 loses in binary before the fraction is cut off.
  return Math.min(Math.max(Math.floor(value + 1e-6), 1), maxPx);
}

/** True where one number is left, which then lies at the bottom of the stack: a fraction handed back would be a heap object. */
function evaluate(expression: SizeExpression, width: number, height: number, slots: Slots): boolean {
  const stack = scratchStack;
  let top = SIZE_STACK_BOTTOM - 1;
  for (let i = 0; i < expression.length; i++) {
    const token = expression[i];
    if (token === undefined) break;
    if (typeof token === 'number') {
      stack[++top] = token;
      continue;
    }
    if ('slot' in token) {
      stack[++top] = slots.numbers[slots.offset(token.slot)] ?? 0;
      continue;
    }
    if (token.op === 'width') stack[++top] = width;
    else if (token.op === 'height') stack[++top] = height;
    else top = applySizeOperation(token.op, stack, top);
  }
  return top === SIZE_STACK_BOTTOM;
}
