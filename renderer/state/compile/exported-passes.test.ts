import { expect, test } from '@jest/globals';
import { chain } from '../../../tests/support/fusion-kit.ts';
import { filteredScene } from '../../../tests/support/material-effects-kit.ts';
import { passesOf } from './exported-passes.ts';

test('says which nodes share a pass with a node, and why it reads a layer from a texture', () => {
  const { fused, wires } = chain(['filter/sepia', 'filter/gaussian-blur', 'filter/vignette']);
  const said = (node: string) => passesOf({ program: fused, separate: wires, folded: [] }, node);
  expect(said('e-0')).toEqual({
    passes: [['pattern-a']],
    inMaterialsOf: [],
    separate: [{ layer: 'e-0.layer', reader: 'e-1', reason: 'the reader reads other pixels than the current one' }],
    folded: null,
  });
  const { passes, separate } = said('e-1');
  expect(passes).toEqual([[], ['e-2']]);
  expect(separate.map(({ layer }) => layer)).toContain('e-0.layer');
  expect(said('e-2')).toEqual({ passes: [['e-1']], inMaterialsOf: [], separate: [], folded: null });
});

test('a node that is left out has no pass', () => {
  const { separate: program, folded } = chain(['filter/sepia', 'filter/grey'], [{}, { amount: 0 }], { fold: true });
  expect(passesOf({ program, separate: [], folded }, 'e-1')).toEqual({
    passes: [],
    inMaterialsOf: [],
    separate: [],
    folded: { reason: 'with its parameters it changes nothing', instead: 'e-0' },
  });
});

test('says in the materials of which scene an effect is computed', () => {
  const { fused, wires } = filteredScene({ effects: [['filter/sepia'], ['filter/grey']] });
  expect(passesOf({ program: fused, separate: wires, folded: [] }, 'e-1')).toEqual({
    passes: [],
    inMaterialsOf: ['scene-a'],
    separate: [],
    folded: null,
  });
});
