import { describe, expect, test } from '@jest/globals';
import type { Control } from '../../program/program.ts';
import { fitText, isOnPanel, layOutPanel, type Measure, PX_PER_M, partAt, SIZES, sliderValueAt } from './panel-layout.ts';

/** Every letter half as wide as high. */
const measure: Measure = (text, sizePx) => (text.length * sizePx) / 2;

const base = { node: 'a', param: 'value', value: 0 };
const slider: Control = { ...base, label: 'Size', kind: 'slider', min: 0, max: 1, step: 0.1 };
const toggle: Control = { ...base, label: 'Light', kind: 'toggle' };
const button: Control = { ...base, label: 'Again', kind: 'button' };
const choice: Control = {
  ...base,
  label: 'Mood',
  kind: 'choice',
  options: ['Warm', 'Cold', 'Somewhere in between the two of them', 'x'.repeat(99)],
};
const ALL = [slider, toggle, choice, button];

describe('the layout of the panel', () => {
  test('nothing overlaps, leaves the card, or is too small to be hit', () => {
    const layout = layOutPanel('Lamp', ALL, measure);
    const boxes = [...layout.parts, ...layout.headings];
    for (const [i, a] of boxes.entries()) {
      expect(isOnPanel(layout, a.x, a.y) && isOnPanel(layout, a.x + a.width - 1, a.y + a.height - 1)).toBe(true);
      for (const b of boxes.slice(i + 1)) {
        expect(a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y).toBe(true);
      }
    }
    for (const part of layout.parts) expect(Math.min(part.width, part.height) / PX_PER_M).toBeGreaterThanOrEqual(0.04);
  });

  test('every part is found at its middle, and none beside them', () => {
    const layout = layOutPanel('Lamp', ALL, measure);
    for (const [i, part] of layout.parts.entries()) {
      expect(partAt(layout, part.x + part.width / 2, part.y + part.height / 2)).toBe(i);
    }
    expect(layout.parts.map(({ control, option }) => [control, option])).toEqual([
      [0, 0],
      [1, 0],
      [2, 0],
      [2, 1],
      [2, 2],
      [2, 3],
      [3, 0],
    ]);
    expect(partAt(layout, SIZES.margin + 1, SIZES.margin + 1)).toBe(-1);
    expect(isOnPanel(layout, 2, layout.heightPx / 2)).toBe(false);
  });

  test('many controls stand in columns, no higher than two reach', () => {
    const layout = layOutPanel(
      'Lamp',
      Array.from({ length: 20 }, () => toggle),
      measure,
    );
    expect(layout.heightPx / PX_PER_M).toBeLessThan(0.6);
    expect(new Set(layout.parts.map(({ x }) => x)).size).toBe(3);
  });

  test('texts too long are cut with an ellipsis', () => {
    expect(fitText('Light', 10, 25, measure)).toBe('Light');
    expect(fitText('A long one', 10, 25, measure)).toBe('A lo…');
    expect(fitText('A long one', 10, 15, measure)).toBe('A…');
  });
});

describe('a slider', () => {
  const part = { control: 0, option: 0, kind: 'slider' as const, text: '', x: 100, y: 0, width: 200 + 2 * SIZES.trackInset, height: 80 };
  const start = 100 + SIZES.trackInset;

  test.each([
    ['its left end and beyond', 0, 0],
    ['its middle', start + 100, 0.5],
    ['between two steps', start + 66, 0.3],
    ['its right end and beyond', 999, 1],
  ])('is set by %s', (_where, x, value) => {
    expect(sliderValueAt({ min: 0, max: 1, step: 0.1 }, part, x)).toBe(value);
  });

  test('stops anywhere without a step, and never beyond the last whole step', () => {
    expect(sliderValueAt({ min: -1, max: 1, step: 0 }, part, start + 33)).toBeCloseTo(-0.67, 12);
    expect(sliderValueAt({ min: 0, max: 1, step: 0.4 }, part, 999)).toBe(0.8);
  });
});
