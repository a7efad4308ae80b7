import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/expression',
  version: 1,
  title: 'Expression',
  doc: 'Computes a number from up to four others by a formula. Write numbers, + − * / % ^, brackets, comparisons (< <= > >= == !=), && || !, a choice as in “a > 1 ? b : c”, the names a b c d, time (seconds since the session began), frame, pi and tau, and the functions sin cos tan asin acos atan atan2 sqrt pow exp log abs sign floor ceil round fract mod min max clamp mix step smoothstep. Angles are in radians, a comparison gives 1 or 0, and % is mod, which has the sign of the divisor. Where the result is no number, as in 1 / 0, it is 0. The same can be written straight into a param.',
  keywords: ['formula', 'math', 'calculate', 'script', 'code', 'sine', 'wave', 'function', 'equation', 'lfo', 'oscillator'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The computed number.' } },
  params: {
    expression: {
      type: 'text',
      stage: 'structure',
      label: 'Expression',
      doc: 'The formula, such as: a + sin(time * tau) * b',
      default: 'a',
      expression: { names: ['a', 'b', 'c', 'd'] },
    },
    a: { type: 'number', stage: 'uniform', label: 'A', doc: 'What a stands for.', default: 0 },
    b: { type: 'number', stage: 'uniform', label: 'B', doc: 'What b stands for.', default: 0 },
    c: { type: 'number', stage: 'uniform', label: 'C', doc: 'What c stands for.', default: 0 },
    d: { type: 'number', stage: 'uniform', label: 'D', doc: 'What d stands for.', default: 0 },
  },
  lowering: { kind: 'value' },
});
