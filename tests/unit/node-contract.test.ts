import { describe, expect, test } from '@jest/globals';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { definitionProblems } from '../support/node-contract.ts';

const GOOD: NodeDefinition = {
  type: 'layer/example',
  version: 1,
  title: 'Example',
  doc: 'Makes a layer.',
  inputs: { objects: { type: 'objects', label: 'Objects', doc: 'What to draw.', required: true } },
  outputs: { layer: { type: 'layer', label: 'Layer', doc: 'The picture.', domain: 'view', depth: true } },
  params: {
    sizeM: { type: 'number', stage: 'uniform', label: 'Size', doc: 'Side.', default: 1, min: 0, max: 2, unit: 'm' },
    look: {
      type: 'choice',
      stage: 'structure',
      label: 'Look',
      doc: 'How.',
      default: 'a',
      options: [
        { value: 'a', label: 'A' },
        { value: 'b', label: 'B' },
      ],
    },
  },
  lowering: { kind: 'geometry' },
};

const { sizeM, look } = GOOD.params as { sizeM: NodeDefinition['params'][string]; look: NodeDefinition['params'][string] };

/** What is said of the good definition with this much changed. */
function problems(change: Partial<NodeDefinition>): string[] {
  return definitionProblems({ ...GOOD, ...change }, (name) => name === 'there.fs');
}

function withParam(name: string, param: object): string[] {
  return problems({ params: { [name]: { type: 'number', stage: 'uniform', label: 'X', doc: 'X.', default: 0, ...param } as never } });
}

describe('the contract of definitions', () => {
  test('a good one has no problems', () => {
    expect(problems({})).toEqual([]);
    expect(problems({ lowering: { kind: 'image', shader: 'there.fs', access: 'pointwise' } })).toEqual([]);
  });

  test.each<[string, string[], string]>([
    ['a doc', problems({ doc: ' ' }), 'has no doc'],
    ['a doc per param', problems({ params: { sizeM: { ...sizeM, doc: '' } as never } }), 'param sizeM has no doc'],
    ['a label per port', problems({ inputs: { o: { type: 'objects', label: '', doc: 'O.', required: true } } }), 'input o has no label'],
    [
      'names of their own',
      problems({ params: { objects: { ...sizeM } as never } }),
      'objects is an input and a param: a wire to it would be ambiguous',
    ],
    ['a migration per version', problems({ version: 2 }), 'version 2 needs 1 migrations, not 0'],
    [
      'what params were renamed to',
      problems({ version: 2, renamed: [{ old: { to: 'gone', times: 1 } }] }),
      'a param was renamed to gone, which there is not',
    ],
    ['a unit for meters', withParam('heightM', {}), 'param heightM: its name says m, its unit nothing'],
    ['the right unit', withParam('angleRad', { unit: 's' }), 'param angleRad: its name says rad, its unit s'],
    ['a default in range', withParam('x', { min: 1 }), 'param x: its default is out of range'],
    ['finite numbers', withParam('x', { max: Number.POSITIVE_INFINITY }), 'param x: not finite'],
    ['whole vectors', withParam('x', { type: 'vector3', default: [1, 2] }), 'param x: default, min and max have 3 numbers each'],
    ['colors in range', withParam('x', { type: 'color', default: [0, 0, 2, 1] }), 'param x: its default is out of range'],
    ['a default among options', problems({ params: { look: { ...look, default: 'c' } as never } }), 'param look: its default is no option'],
    [
      'words in a structure choice',
      problems({ params: { look: { ...look, stage: 'uniform' } as never } }),
      'param look: a uniform choice holds numbers',
    ],
    [
      'what a layer is',
      problems({ outputs: { layer: { type: 'layer', label: 'L', doc: 'L.' } } }),
      'output layer has to say its domain and depth',
    ],
    [
      'same as something',
      problems({ outputs: { layer: { type: 'layer', label: 'L', doc: 'L.', domain: 'same', depth: false } } }),
      'output layer cannot be the same as an input layer: there is none',
    ],
    ['a shader that exists', problems({ lowering: { kind: 'image', shader: 'no.fs', access: 'pointwise' } }), 'there is no shader no.fs'],
    [
      'pulses from several wires',
      problems({ inputs: { go: { type: 'pulse', label: 'Go', doc: 'Go.', required: false } } }),
      'input go has to take pulses of several wires',
    ],
    [
      'what its control needs',
      problems({
        control: 'toggle',
        params: {
          label: { type: 'text', stage: 'structure', label: 'L', doc: 'L.', default: '' },
          place: { type: 'number', stage: 'structure', label: 'P', doc: 'P.', default: 0 },
        },
      }),
      'a toggle has a param value, a uniform toggle',
    ],
    [
      'shadow maps from its own ports',
      problems({ lowering: { kind: 'geometry', shadowMap: { casters: ['objects'], lights: 'sun' } } }),
      'lights sun is no input of lights',
    ],
    ['a number to be stateful by', problems({ stateful: { param: 'look', above: 0 } }), 'it is stateful by look, no uniform number'],
    ['a param that moves', problems({ stateful: { moves: ['look'] } }), 'it is stateful by look, no uniform param'],
    [
      'a reason to ask',
      problems({ needs: [{ capability: 'depth', required: false, when: 'always', why: 'depth', without: 'Nothing is hidden.' }] }),
      'why it needs depth has to read "to …"',
    ],
  ])('every definition has %s', (_what, found, expected) => {
    expect(found).toEqual([expected]);
  });
});
