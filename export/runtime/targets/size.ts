import type { SizeExpression } from '../../program/program.ts';
import type { Slots } from '../values/slots.ts';

/** More than an expression of the 500 characters that the compiler takes can need. */
const STACK = 512;

/** Two places below stay empty, so that looking at the top two never leaves the array. */
const BOTTOM = 2;

/** Reused by every evaluation: an evaluation never starts another one. */
const scratchStack = new Float64Array(STACK);

/** Whole pixels, at least one, at most `maxPx`; a size that is not a number is one pixel. */
export function evaluateSize(expression: SizeExpression, baseWidthPx: number, baseHeightPx: number, slots: Slots, maxPx: number): number {
  const value = evaluate(expression, baseWidthPx, baseHeightPx, slots) ? (scratchStack[BOTTOM] ?? 1) : 1;
  if (Number.isNaN(value)) return 1;
  // The margin takes back what 0.57 * 100 loses in binary before the fraction is cut off.
  return Math.min(Math.max(Math.floor(value + 1e-6), 1), maxPx);
}

/** True where one number is left, which then lies at the bottom of the stack: a fraction handed back would be a heap object. */
function evaluate(expression: SizeExpression, width: number, height: number, slots: Slots): boolean {
  const stack = scratchStack;
  let top = BOTTOM - 1;
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
    const a = stack[top - 1] ?? 0;
    const b = stack[top] ?? 0;
    switch (token.op) {
      case 'width':
        stack[++top] = width;
        break;
      case 'height':
        stack[++top] = height;
        break;
      case '+':
        stack[--top] = a + b;
        break;
      case '-':
        stack[--top] = a - b;
        break;
      case '*':
        stack[--top] = a * b;
        break;
      case '/':
        stack[--top] = a / b;
        break;
      case '%':
        stack[--top] = a % b;
        break;
      case 'min':
        stack[--top] = Math.min(a, b);
        break;
      case 'max':
        stack[--top] = Math.max(a, b);
        break;
      case 'negate':
        stack[top] = -b;
        break;
      case 'floor':
        stack[top] = Math.floor(b);
        break;
      case 'ceil':
        stack[top] = Math.ceil(b);
        break;
      case 'abs':
        stack[top] = Math.abs(b);
        break;
      case 'round':
        stack[top] = Math.round(b);
        break;
      case 'sqrt':
        stack[top] = Math.sqrt(b);
        break;
      default:
        exhaustive(token.op);
    }
  }
  return top === BOTTOM;
}

function exhaustive(op: never): never {
  throw new Error(`Unknown size operation ${String(op)}.`);
}
