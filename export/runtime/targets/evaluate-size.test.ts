import { describe, expect, test } from '@jest/globals';
import type { SizeExpression, SizeToken } from '../../program/program.ts';
import { createSlots } from '../values/slots.ts';
import { evaluateSize } from './evaluate-size.ts';

const slots = createSlots({
  numbers: [0.57, 3],
  texts: [],
  slots: [
    { type: 'number', offset: 0 },
    { type: 'number', offset: 1 },
  ],
  params: {},
});

const op = (name: Extract<SizeToken, { op: string }>['op']): SizeToken => ({ op: name });

function size(...expression: SizeExpression): number {
  return evaluateSize(expression, 640, 360, slots, 8192);
}

describe('a size expression', () => {
  test.each<[string, SizeExpression, number]>([
    ['floor($WIDTH / 3)', [op('width'), 3, op('/'), op('floor')], 213],
    ['max($HEIGHT * 0.25, 100)', [op('height'), 0.25, op('*'), 100, op('max')], 100],
    ['min($WIDTH, $HEIGHT)', [op('width'), op('height'), op('min')], 360],
    ['$WIDTH - $HEIGHT', [op('width'), op('height'), op('-')], 280],
    ['$WIDTH % 7', [op('width'), 7, op('%')], 3],
    ['abs(-(5 + 2))', [5, 2, op('+'), op('negate'), op('abs')], 7],
    ['ceil(sqrt(50))', [50, op('sqrt'), op('ceil')], 8],
    ['round(2.5)', [2.5, op('round')], 3],
    ['pow(2, 5)', [2, 5, op('^')], 32],
    ['log2(1024)', [1024, op('log2')], 10],
    ['$WIDTH < $HEIGHT ? 3 : 4', [op('width'), op('height'), op('<'), 3, 4, op('?:')], 4],
    ['!($WIDTH <= 5) && 1 == 1 ? 3 : 4', [op('width'), 5, op('<='), op('!'), 1, 1, op('=='), op('&&'), 3, 4, op('?:')], 3],
    ['(0 || 0) + 2', [0, 0, op('||'), 2, op('+')], 2],
    ['$slot1 * 10', [{ slot: 1 }, 10, op('*')], 30],
  ])('%s', (_text, expression, expected) => {
    expect(size(...expression)).toBe(expected);
  });

  test('cuts fractions off, but not what binary numbers lose', () => {
    expect(size(12.9)).toBe(12);
    // 0.57 * 100 is 56.99999999999999.
    expect(size({ slot: 0 }, 100, op('*'))).toBe(57);
  });

  test('is at least one pixel and at most what the GPU takes', () => {
    expect(size(-3)).toBe(1);
    expect(size(1, 0, op('/'))).toBe(8192);
    expect(size(0, 0, op('/'))).toBe(1);
    expect(size(1e9)).toBe(8192);
  });

  test('that leaves no single number is one pixel', () => {
    expect(size()).toBe(1);
    expect(size(1, 2)).toBe(1);
    expect(size(op('+'))).toBe(1);
    expect(size(op('?:'))).toBe(1);
  });
});
