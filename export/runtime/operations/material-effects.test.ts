import { expect, test } from '@jest/globals';
import type { PassUniform, SlotTable } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';
import type { LiveResources } from '../resources/resources.ts';
import { createSlots } from '../values/slots.ts';
import { createMaterialEffects } from './material-effects.ts';

const TABLE: SlotTable = {
  numbers: [0.5, 3.7, 1, 0.1, 0.2, 0.3, 0.4],
  texts: [],
  slots: [
    { type: 'number', offset: 0 },
    { type: 'number', offset: 1 },
    { type: 'toggle', offset: 2 },
    { type: 'color', offset: 3 },
  ],
  params: { 'e-0.amount': 0 },
};

function effects(uniforms: readonly PassUniform[], resources: object = {}) {
  const slots = createSlots(TABLE);
  const live = new Map(Object.entries(resources)) as unknown as LiveResources;
  const made = createMaterialEffects({ effects: { nodes: [], text: '', uniforms, trial: null } }, live, slots);
  if (made === null) throw new Error('There are effects.');
  const values = () => Object.fromEntries(Object.entries(made.uniforms).map(([name, { value }]) => [name, value]));
  return { set: made.set, values, slots };
}

const state = (timeS: number) => ({ frame: { timeS, deltaS: 0.25, index: 7 } }) as unknown as PlayState;

test('uniforms have the values of their slots, as their types need them', () => {
  const { set, values, slots } = effects([
    { name: 'amount', type: 'float', source: { slot: 0 } },
    { name: 'kind', type: 'int', source: { slot: 1 } },
    { name: 'on', type: 'bool', source: { slot: 2 } },
    { name: 'tint', type: 'vec4', source: { slot: 3 } },
  ]);
  set(state(0));
  expect(values()).toEqual({ amount: 0.5, kind: 3, on: 1, tint: Float32Array.of(0.1, 0.2, 0.3, 0.4) });
  slots.numbers[0] = 0.75;
  slots.numbers[2] = 0;
  set(state(0));
  expect(values()).toMatchObject({ amount: 0.75, on: 0 });
});

test('uniforms follow the clock, and are true in frames with a pulse', () => {
  const queue = { count: 0 };
  const { set, values } = effects(
    [
      { name: 'TIME', type: 'float', source: { builtin: 'TIME' } },
      { name: 'TIMEDELTA', type: 'float', source: { builtin: 'TIMEDELTA' } },
      { name: 'FRAMEINDEX', type: 'int', source: { builtin: 'FRAMEINDEX' } },
      { name: 'flash', type: 'bool', source: { pulses: ['tap-a.tapped'] } },
    ],
    { 'tap-a.tapped': { kind: 'pulses', queue } },
  );
  set(state(1.5));
  expect(values()).toEqual({ TIME: 1.5, TIMEDELTA: 0.25, FRAMEINDEX: 7, flash: 0 });
  queue.count = 2;
  set(state(2));
  expect(values()).toMatchObject({ TIME: 2, flash: 1 });
});
