import { describe, expect, test } from '@jest/globals';
import type { PulseList } from '../../../nodes/kit/runtime.ts';
import { PULSE_CAPACITY } from '../../../nodes/kit/runtime.ts';
import { createMergedPulses, createPulseQueue } from './pulses.ts';

function numbers(list: PulseList): number[] {
  return Array.from({ length: list.count }, (_, i) => list.at(i).number);
}

function queueOf(...values: number[]) {
  const queue = createPulseQueue();
  for (const value of values) queue.emit().number = value;
  return queue;
}

describe('a queue of pulses', () => {
  test('gives them oldest first, and none after it was emptied', () => {
    const queue = queueOf(3, 1, 2);
    expect(numbers(queue)).toEqual([3, 1, 2]);
    queue.clear();
    expect(queue.count).toBe(0);
    expect(() => queue.at(0)).toThrow(RangeError);
  });

  test('a new pulse brings nothing of those that stood in its place before', () => {
    const queue = createPulseQueue();
    const first = queue.emit();
    first.number = 7;
    first.text = 'hello';
    first.bodyKey = 'ball';
    first.setPose(new Float32Array(16).fill(2));
    queue.clear();
    queue.emit();
    expect(queue.at(0)).toMatchObject({ number: 0, text: '', bodyKey: '', worldFromPose: null });
  });

  test('a pulse like another brings all that this brings, and is another', () => {
    const from = createPulseQueue();
    const original = from.emit();
    original.number = 7;
    original.text = 'hello';
    original.bodyKey = 'ball';
    original.setPose(Float32Array.from({ length: 16 }, (_, i) => i));
    const to = createPulseQueue();
    to.emit(from.at(0));
    original.setPose(new Float32Array(16));
    original.number = 0;
    expect(to.at(0)).toMatchObject({ number: 7, text: 'hello', bodyKey: 'ball' });
    expect([...(to.at(0).worldFromPose ?? [])]).toEqual(Array.from({ length: 16 }, (_, i) => i));
  });

  test('drops what is beyond its capacity, and says so', () => {
    const queue = createPulseQueue();
    let dropped = 0;
    queue.onOverflow = () => dropped++;
    for (let i = 0; i < PULSE_CAPACITY + 3; i++) queue.emit().number = i;
    expect([queue.count, dropped]).toEqual([PULSE_CAPACITY, 3]);
    expect(numbers(queue)).toEqual(Array.from({ length: PULSE_CAPACITY }, (_, i) => i));
  });
});

describe('merged pulses', () => {
  test('come wire by wire, and follow other wires', () => {
    const [a, b, empty] = [queueOf(1, 2), queueOf(3), queueOf()];
    const merged = createMergedPulses([b, empty, a]);
    expect(numbers(merged)).toEqual([3, 1, 2]);
    a.emit().number = 9;
    expect(numbers(merged)).toEqual([3, 1, 2, 9]);
    merged.point([a]);
    expect(numbers(merged)).toEqual([1, 2, 9]);
    expect(() => merged.at(3)).toThrow(RangeError);
    expect(createMergedPulses([]).count).toBe(0);
  });
});
