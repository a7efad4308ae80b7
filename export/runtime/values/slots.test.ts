import { describe, expect, test } from '@jest/globals';
import { DIAGONAL, paddedCurve } from '../../../nodes/kit/curve.ts';
import type { SlotTable } from '../../program/program.ts';
import { createSlots, createSlotView } from './slots.ts';

const TABLE: SlotTable = {
  numbers: [1, 0, 0.1, 0.2, 0.3, 0.4],
  texts: ['hello'],
  slots: [
    { type: 'number', offset: 0 },
    { type: 'toggle', offset: 1 },
    { type: 'color', offset: 2 },
    { type: 'text', offset: 0 },
    { type: 'vector2', offset: 4 },
  ],
  params: { 'a.number': 0, 'a.toggle': 1, 'a.color': 2, 'a.text': 3 },
};

describe('slots', () => {
  test('take values of their type and no others', () => {
    const slots = createSlots(TABLE);
    expect([slots.set(0, 5), slots.set(1, true), slots.set(2, [0, 0.5, 1, 1]), slots.set(3, 'bye')]).toEqual([true, true, true, true]);
    expect([...slots.numbers]).toEqual([5, 1, 0, 0.5, 1, 1]);
    expect(slots.texts).toEqual(['bye']);
    const refused = [
      slots.set(0, 'x'),
      slots.set(0, Number.NaN),
      slots.set(2, [1, 2]),
      slots.set(2, [0, 0, 0, Number.POSITIVE_INFINITY]),
      slots.set(3, 1),
      slots.set(2, 1),
    ];
    expect(refused).toEqual([false, false, false, false, false, false]);
    expect([...slots.numbers]).toEqual([5, 1, 0, 0.5, 1, 1]);
  });

  test('leave the program they were made from alone', () => {
    createSlots(TABLE).set(0, 9);
    expect(createSlots(TABLE).numbers[0]).toBe(1);
  });

  test('are found by node and param', () => {
    const slots = createSlots(TABLE);
    expect(slots.find('a.color')).toBe(2);
    expect(slots.find('a.nothing')).toBeUndefined();
    expect(slots.find('toString')).toBeUndefined();
  });
});

test('of curves take any that is one, and hold it padded with its last point', () => {
  const numbers = [...paddedCurve(DIAGONAL)];
  const slots = createSlots({ numbers, texts: [], slots: [{ type: 'curve', offset: 0 }], params: { 'a.curve': 0 } });
  expect(slots.set(0, [0, 1, 0.5, 0.25, 1, 0])).toBe(true);
  expect([...slots.numbers]).toEqual([0, 1, 0.5, 0.25, ...new Array(6).fill([1, 0]).flat()]);
  const before = [...slots.numbers];
  for (const wrong of [[], [0, 0, 1], new Array<number>(18).fill(0), [0, Number.NaN, 1, 1], 1, 'x'])
    expect(slots.set(0, wrong)).toBe(false);
  expect([...slots.numbers]).toEqual(before);
});

describe('a view', () => {
  test('reads and writes its slot, as its type has it', () => {
    const slots = createSlots(TABLE);
    const toggle = createSlotView(slots, 1);
    expect(toggle.value).toBe(false);
    toggle.value = true;
    expect(slots.numbers[1]).toBe(1);
    const color = createSlotView(slots, 2);
    expect(color.value).toBe(color.value);
    color.value = Float64Array.of(1, 1, 1, 0.5);
    expect([...slots.numbers.subarray(2)]).toEqual([1, 1, 1, 0.5]);
    const text = createSlotView(slots, 3);
    text.value = 'new';
    expect(slots.texts).toEqual(['new']);
  });

  test('can be pointed at another slot of another table', () => {
    const view = createSlotView(createSlots(TABLE), 0);
    const next = createSlots({ ...TABLE, numbers: [0, 0, 0, 0, 0, 7], slots: [{ type: 'number', offset: 5 }] });
    view.point(next, 0);
    expect(view.value).toBe(7);
  });

  test('two slots of different types may share their numbers, which is how a wire converts', () => {
    const slots = createSlots({
      numbers: [1],
      texts: [],
      slots: [
        { type: 'toggle', offset: 0 },
        { type: 'number', offset: 0 },
      ],
      params: {},
    });
    expect([createSlotView(slots, 0).value, createSlotView(slots, 1).value]).toEqual([true, 1]);
  });

  test('of a slot that is not there is a fault of the program', () => {
    expect(() => createSlotView(createSlots(TABLE), 99)).toThrow('no slot 99');
  });
});
