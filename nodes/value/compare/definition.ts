import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/compare',
  version: 1,
  title: 'Compare',
  doc: 'Compares two numbers and outputs on or off. Connect it to a Gate, a Switch node or any toggle.',
  keywords: ['if', 'greater', 'less', 'equal', 'threshold', 'condition', 'logic', 'test', 'more', 'bigger', 'smaller'],
  inputs: {},
  outputs: { result: { type: 'toggle', label: 'Result', doc: 'On if the comparison is true.' } },
  params: {
    operation: {
      type: 'choice',
      stage: 'structure',
      label: 'Operation',
      doc: 'The comparison.',
      default: 'greater',
      options: [
        { value: 'greater', label: 'A is greater than B' },
        { value: 'greater-equal', label: 'A is greater than or equal to B' },
        { value: 'less', label: 'A is less than B' },
        { value: 'less-equal', label: 'A is less than or equal to B' },
        { value: 'equal', label: 'A equals B' },
        { value: 'not-equal', label: 'A does not equal B' },
      ],
    },
    a: { type: 'number', stage: 'uniform', label: 'A', doc: 'First number.', default: 0 },
    b: { type: 'number', stage: 'uniform', label: 'B', doc: 'Second number.', default: 0 },
    tolerance: {
      type: 'number',
      stage: 'uniform',
      label: 'Tolerance',
      doc: 'Numbers that differ by at most this count as equal.',
      default: 0,
      min: 0,
    },
  },
  computes: {
    result: {
      by: 'operation',
      of: {
        greater: 'a - b > max(tolerance, 0)',
        'greater-equal': 'a - b >= -max(tolerance, 0)',
        less: 'a - b < -max(tolerance, 0)',
        'less-equal': 'a - b <= max(tolerance, 0)',
        equal: 'abs(a - b) <= max(tolerance, 0)',
        'not-equal': 'abs(a - b) > max(tolerance, 0)',
      },
    },
  },
  lowering: { kind: 'value' },
});
