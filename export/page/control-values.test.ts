import { expect, test } from '@jest/globals';
import type { Control } from '../program/program.ts';
import { createControlValues } from './control-values.ts';

const CONTROLS: readonly Control[] = [
  { node: 'a', param: 'value', label: 'Size', kind: 'slider', min: 0, max: 1, step: 0, value: 0.25 },
  { node: 'b', param: 'value', label: 'Light', kind: 'toggle', value: 1 },
];

test('all who show a control hear what it is set to, and the picture is told once', () => {
  const told: unknown[] = [];
  const heard: number[] = [];
  const values = createControlValues(CONTROLS, ({ node }, value) => told.push([node, value]));
  const stop = values.listen((index) => heard.push(index));
  values.set(0, 0.5);
  values.set(0, 0.5);
  values.set(1, 0);
  values.set(7, 1);
  stop();
  values.set(0, 1);
  expect(told).toEqual([
    ['a', 0.5],
    ['b', false],
    ['a', 1],
  ]);
  expect(heard).toEqual([0, 1]);
  expect([values.get(0), values.get(1)]).toEqual([1, 0]);
});
