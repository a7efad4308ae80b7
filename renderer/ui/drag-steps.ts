import { type DragKeys, FINENESS } from '../drag-keys.ts';

/** Drag of a slider. */
export interface SliderDrag {
  /**
   * Value for the drag.
   *
   * @param pointed Value at the pointer, in the unit of the slider.
   * @param shown Value before this movement.
   */
  move(pointed: number, shown: number, keys: DragKeys): number;
}

const STEPS_PER_SNAP = 10;

/** @param step Step of the slider, above 0. */
export function createSliderDrag(step: number): SliderDrag {
  /** Where the fine part of the drag began. */
  let fineFrom: { readonly pointed: number; readonly value: number } | null = null;
  let lastPointed: number | null = null;
  return {
    move: (pointed, shown, { fine, snap }) => {
      if (!fine) fineFrom = null;
      else fineFrom ??= { pointed: lastPointed ?? pointed, value: shown };
      lastPointed = pointed;
      const value = fineFrom === null ? pointed : fineFrom.value + (pointed - fineFrom.pointed) / FINENESS;
      return snap ? snapped(value, step) : withoutBinaryError(value);
    },
  };
}

/**
 * Value of a number field during a sideways drag.
 *
 * @param from Value at its start.
 * @param steps Steps that the pointer has moved by, whole.
 */
export function scrubbedValue(from: number, steps: number, step: number, { fine, snap }: DragKeys): number {
  const value = from + (steps * step) / (fine ? FINENESS : 1);
  return snap ? snapped(value, step) : withoutBinaryError(value);
}

/** Value of a slider or a number field after an arrow key: one step on, or the next whole ten of steps with `snap`. */
export function keyedValue(from: number, direction: 1 | -1, step: number, { fine, snap }: DragKeys): number {
  if (!snap) return withoutBinaryError(from + (direction * step) / (fine ? FINENESS : 1));
  const grid = step * STEPS_PER_SNAP;
  const tens = withoutBinaryError((from * direction) / grid);
  return withoutBinaryError((Math.floor(tens) + 1) * grid * direction);
}

function snapped(value: number, step: number): number {
  const grid = step * STEPS_PER_SNAP;
  return withoutBinaryError(Math.round(value / grid) * grid);
}

/** Removes binary rounding errors from sums of decimal steps. */
function withoutBinaryError(value: number): number {
  return Number(value.toPrecision(12));
}
