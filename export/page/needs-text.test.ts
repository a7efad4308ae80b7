import { expect, test } from '@jest/globals';
import type { ProgramNeed } from '../program/needs.ts';
import { asksOf } from './needs-text.ts';

const need = (more: Partial<ProgramNeed>): ProgramNeed => ({
  capability: 'depth',
  required: false,
  nodes: ['a-1'],
  why: 'to hide things behind furniture',
  without: 'Things are drawn in front of everything.',
  ...more,
});

test('one line per capability, with every reason once, required ones first', () => {
  const asks = asksOf([
    need({}),
    need({ nodes: ['b-2'] }),
    need({ nodes: ['c-3'], why: 'to clip shadows', without: 'shadows lie on furniture' }),
    need({ capability: 'camera-image', required: true, why: 'to draw the room as a sketch.' }),
  ]);
  expect(asks).toEqual([
    { what: 'The camera feed', why: 'To draw the room as a sketch. Required.', required: true },
    {
      what: 'The depth of the room',
      why: 'To hide things behind furniture, and to clip shadows. Without it: things are drawn in front of everything; shadows lie on furniture.',
      required: false,
    },
  ]);
});

test('nothing needed, nothing asked', () => {
  expect(asksOf([])).toEqual([]);
});
