import { playSize, SIZE_STACK_BOTTOM } from '../../../nodes/kit/play-size.ts';
import type { SizeExpression, SizeToken } from '../../program/program.ts';
import type { Slots } from '../values/slots.ts';

/** Size of the evaluation stack: more than any expression needs within the compiler's limit of 500 characters. */
const STACK = 512;

// Reused by every evaluation, because evaluations do not nest.
const scratchStack = new Float64Array(STACK);

/** Evaluates a size to whole pixels from 1 to `maxPx`. NaN gives 1. */
export function evaluateSize(expression: SizeExpression, baseWidthPx: number, baseHeightPx: number, slots: Slots, maxPx: number): number {
  const isSize = playSize(expression, baseWidthPx, baseHeightPx, putSlot, slots, scratchStack);
  const value = isSize ? (scratchStack[SIZE_STACK_BOTTOM] ?? 1) : 1;
  if (Number.isNaN(value)) return 1;
  // The margin compensates rounding errors, such as of 0.57 * 100, before the value is rounded down.
  return Math.min(Math.max(Math.floor(value + 1e-6), 1), maxPx);
}

function putSlot({ slot }: Extract<SizeToken, { slot: number }>, slots: Slots, stack: Float64Array, at: number): void {
  stack[at] = slots.numbers[slots.offset(slot)] ?? 0;
}
