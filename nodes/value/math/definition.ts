import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/math',
  version: 1,
  title: 'Math',
  doc: 'Computes one number from two. Division and remainder by zero give 0, so that no NaN reaches an image.',
  keywords: ['add', 'subtract', 'multiply', 'divide', 'plus', 'minus', 'sine', 'cosine', 'power'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The computed number.' } },
  params: {
    operation: {
      type: 'choice',
      stage: 'structure',
      label: 'Operation',
      doc: 'The operation.',
      default: 'add',
      options: [
        { value: 'add', label: 'A + B' },
        { value: 'subtract', label: 'A − B' },
        { value: 'multiply', label: 'A × B' },
        { value: 'divide', label: 'A ÷ B' },
        { value: 'remainder', label: 'Remainder of A ÷ B' },
        { value: 'power', label: 'A to the power B' },
        { value: 'minimum', label: 'Minimum of A, B' },
        { value: 'maximum', label: 'Maximum of A, B' },
        { value: 'sine', label: 'Sine of A × B' },
        { value: 'cosine', label: 'Cosine of A × B' },
      ],
    },
    a: { type: 'number', stage: 'uniform', label: 'A', doc: 'First number.', default: 0 },
    b: { type: 'number', stage: 'uniform', label: 'B', doc: 'Second number.', default: 1 },
  },
  computes: {
    result: {
      by: 'operation',
      of: {
        add: 'a + b',
        subtract: 'a - b',
        multiply: 'a * b',
        divide: 'b == 0 ? 0 : a / b',
        remainder: 'b == 0 ? 0 : a - b * floor(a / b)',
        power: 'a ^ b',
        minimum: 'min(a, b)',
        maximum: 'max(a, b)',
        sine: 'sin(a * b)',
        cosine: 'cos(a * b)',
      },
    },
  },
  lowering: { kind: 'value' },
});
