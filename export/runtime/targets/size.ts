import { playSize, SIZE_STACK_BOTTOM } from '../../../nodes/kit/play-size.ts';
import type { SizeExpression, SizeToken } from '../../program/program.ts';
import type { Slots } from '../values/slots.ts';

/** More than an expression of the 500 characters that the compiler takes can need. */
const STACK = 512;

// Reused by every evaluation: an evaluation never starts another one.
const scratchStack = new Float64Array(STACK);

/** Whole pixels, at least one, at most `maxPx`; a size that is not a number is one pixel. */
export function evaluateSize(expression: SizeExpression, baseWidthPx: number, baseHeightPx: number, slots: Slots, maxPx: number): number {
  const isSize = playSize(expression, baseWidthPx, baseHeightPx, putSlot, slots, scratchStack);
  const value = isSize ? (scratchStack[SIZE_STACK_BOTTOM] ?? 1) : 1;
  if (Number.isNaN(value)) return 1;
  // The margin takes back what 0.57 * 100 loses in binary before the fraction is cut off.
  return Math.min(Math.max(Math.floor(value + 1e-6), 1), maxPx);
}

function putSlot({ slot }: Extract<SizeToken, { slot: number }>, slots: Slots, stack: Float64Array, at: number): void {
  stack[at] = slots.numbers[slots.offset(slot)] ?? 0;
}
