import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/compare',
  version: 1,
  title: 'Compare',
  doc: 'Compares two numbers and is on or off. Connect it to a Gate, a Switch or anything that can be turned on.',
  keywords: ['if', 'greater', 'less', 'equal', 'threshold', 'condition', 'logic', 'test', 'more', 'bigger', 'smaller'],
  inputs: {},
  outputs: { result: { type: 'toggle', label: 'Result', doc: 'Whether it is so.' } },
  params: {
    operation: {
      type: 'choice',
      stage: 'structure',
      label: 'Operation',
      doc: 'What has to be so.',
      default: 'greater',
      options: [
        { value: 'greater', label: 'A is more than B' },
        { value: 'greater-equal', label: 'A is B or more' },
        { value: 'less', label: 'A is less than B' },
        { value: 'less-equal', label: 'A is B or less' },
        { value: 'equal', label: 'A is B' },
        { value: 'not-equal', label: 'A is not B' },
      ],
    },
    a: { type: 'number', stage: 'uniform', label: 'A', doc: 'First number.', default: 0 },
    b: { type: 'number', stage: 'uniform', label: 'B', doc: 'Second number.', default: 0 },
    tolerance: {
      type: 'number',
      stage: 'uniform',
      label: 'Tolerance',
      doc: 'Numbers no further apart than this count as equal.',
      default: 0,
      min: 0,
    },
  },
  lowering: { kind: 'value' },
});
