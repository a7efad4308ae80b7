import { CURVE_NUMBERS, paddedPoints } from '../../../nodes/kit/curve.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { GRADIENT_NUMBERS, STOP_NUMBERS } from '../../../nodes/kit/gradient.ts';
import type { NumberView, TextView, ToggleView, VectorView, Writable } from '../../../nodes/kit/value-views.ts';
import type { Slot, SlotTable, SlotType } from '../../program/program.ts';

/** Current values of a program: one flat array of numbers and one of texts. */
export interface Slots {
  readonly numbers: Float64Array;
  readonly texts: string[];
  readonly slots: readonly Slot[];
  /** The slot of `node.param`, or undefined if the program has no such value. */
  find(name: string): number | undefined;
  /** Index of the slot's first number, or of its text. */
  offset(slot: number): number;
  /** How many numbers the slot has. */
  size(slot: number): number;
  /** Sets the value of a slot. Returns false, and keeps the old value, if the new one does not fit the slot's type or is not finite. */
  set(slot: number, value: ParamValue): boolean;
}

export function createSlots(table: SlotTable): Slots {
  const numbers = Float64Array.from(table.numbers);
  const texts = [...table.texts];
  return {
    numbers,
    texts,
    slots: table.slots,
    find: (name) => (Object.hasOwn(table.params, name) ? table.params[name] : undefined),
    offset: (index) => slotAt(table.slots, index).offset,
    size: (index) => {
      const { type } = slotAt(table.slots, index);
      return type === 'text' ? 0 : NUMBERS_IN[type];
    },
    set: (index, value) => {
      const { type, offset } = slotAt(table.slots, index);
      if (type === 'text') {
        if (typeof value !== 'string') return false;
        texts[offset] = value;
        return true;
      }
      const size = NUMBERS_IN[type];
      if (typeof value === 'string') return false;
      if (typeof value === 'object') {
        const list = type === 'curve' || type === 'gradient' ? paddedPoints(value, type === 'curve' ? 2 : STOP_NUMBERS, size) : value;
        if (list.length !== size || !list.every(Number.isFinite)) return false;
        numbers.set(list, offset);
        return true;
      }
      const number = Number(value);
      if (size !== 1 || !Number.isFinite(number)) return false;
      numbers[offset] = type === 'toggle' ? Number(number !== 0) : number;
      return true;
    },
  };
}

const NUMBERS_IN: Readonly<Record<Exclude<SlotType, 'text'>, number>> = {
  number: 1,
  toggle: 1,
  vector2: 2,
  vector3: 3,
  vector4: 4,
  color: 4,
  curve: CURVE_NUMBERS,
  gradient: GRADIENT_NUMBERS,
};

/**
 * A node's view of a slot. A recompile moves values to other slots while the node continues, so the view can be connected to another slot.
 * Nodes therefore keep views instead of arrays.
 */
export interface SlotView {
  point(slots: Slots, slot: number): void;
}

export type AnySlotView = SlotView & Writable<NumberView | ToggleView | TextView | VectorView>;

export function createSlotView(slots: Slots, slot: number): AnySlotView {
  const view = emptyView(slotAt(slots.slots, slot).type);
  view.point(slots, slot);
  return view;
}

function emptyView(type: SlotType): AnySlotView {
  switch (type) {
    case 'number':
      return new NumberSlot();
    case 'toggle':
      return new ToggleSlot();
    case 'text':
      return new TextSlot();
    case 'vector2':
    case 'vector3':
    case 'vector4':
    case 'color':
    case 'curve':
    case 'gradient':
      return new VectorSlot();
  }
}

class NumberSlot implements SlotView, NumberView {
  private numbers: Float64Array = new Float64Array(1);
  private offset = 0;
  get value(): number {
    return this.numbers[this.offset] ?? 0;
  }
  set value(value: number) {
    this.numbers[this.offset] = value;
  }
  point(slots: Slots, slot: number): void {
    this.numbers = slots.numbers;
    this.offset = slotAt(slots.slots, slot).offset;
  }
}

class ToggleSlot implements SlotView, ToggleView {
  private numbers: Float64Array = new Float64Array(1);
  private offset = 0;
  get value(): boolean {
    return this.numbers[this.offset] !== 0;
  }
  set value(value: boolean) {
    this.numbers[this.offset] = value ? 1 : 0;
  }
  point(slots: Slots, slot: number): void {
    this.numbers = slots.numbers;
    this.offset = slotAt(slots.slots, slot).offset;
  }
}

class TextSlot implements SlotView, TextView {
  private texts: string[] = [];
  private offset = 0;
  get value(): string {
    return this.texts[this.offset] ?? '';
  }
  set value(value: string) {
    this.texts[this.offset] = value;
  }
  point(slots: Slots, slot: number): void {
    this.texts = slots.texts;
    this.offset = slotAt(slots.slots, slot).offset;
  }
}

/** A view of a slot with several numbers. Assigning an array copies its numbers to the slot. */
class VectorSlot implements SlotView, VectorView {
  private numbers: Float64Array = new Float64Array(4);
  get value(): Readonly<Float64Array> {
    return this.numbers;
  }
  set value(value: Readonly<Float64Array>) {
    this.numbers.set(value);
  }
  point(slots: Slots, slot: number): void {
    const { type, offset } = slotAt(slots.slots, slot);
    this.numbers = slots.numbers.subarray(offset, offset + (type === 'text' ? 0 : NUMBERS_IN[type]));
  }
}

function slotAt(slots: readonly Slot[], index: number): Slot {
  const slot = slots[index];
  if (!slot) throw new Error(`The program has no slot ${index}.`);
  return slot;
}
