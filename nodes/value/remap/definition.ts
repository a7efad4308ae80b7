import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/remap',
  version: 1,
  title: 'Remap',
  doc: 'Moves a number from one range to another: a slider’s 0 to 1 becomes −30 to 30, or seconds become brightness. The ends may be the wrong way round, which turns the range over.',
  keywords: ['map', 'range', 'scale', 'fit', 'normalize', 'normalize', 'lerp', 'interpolate', 'smoothstep'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The number in its new range.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'What to move.', default: 0.5 },
    fromLow: { type: 'number', stage: 'uniform', label: 'From low', doc: 'Where the old range begins.', default: 0 },
    fromHigh: {
      type: 'number',
      stage: 'uniform',
      label: 'From high',
      doc: 'Where the old range ends. Equal to its beginning, the range is a step.',
      default: 1,
    },
    toLow: { type: 'number', stage: 'uniform', label: 'To low', doc: 'Where the new range begins.', default: 0 },
    toHigh: { type: 'number', stage: 'uniform', label: 'To high', doc: 'Where the new range ends.', default: 1 },
    clamp: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Clamp',
      doc: 'Whether numbers beyond the old range stop at the ends of the new one.',
      default: true,
    },
    curve: {
      type: 'choice',
      stage: 'structure',
      label: 'Curve',
      doc: 'Even: as far in the new range as in the old one. Smooth: slow at both ends, and never beyond them.',
      default: 'even',
      options: [
        { value: 'even', label: 'Even' },
        { value: 'smooth', label: 'Smooth' },
      ],
    },
  },
  lowering: { kind: 'value' },
});
