import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/expression',
  version: 1,
  title: 'Expression',
  doc: 'Computes a number from up to four others with an expression. Operators: + − * / % ^, comparisons (< <= > >= == !=), && || !, parentheses, and a conditional as in “a > 1 ? b : c”. Names: a b c d, time (seconds since the session began), frame, pi and tau. Functions: sin cos tan asin acos atan atan2 sqrt pow exp log abs sign floor ceil round fract mod min max clamp mix step smoothstep. Angles are in radians, a comparison gives 1 or 0, and % is mod, whose result has the sign of the divisor. A result that is not finite, as in 1 / 0, becomes 0. A parameter accepts the same expressions directly.',
  keywords: ['formula', 'math', 'calculate', 'script', 'code', 'sine', 'wave', 'function', 'equation', 'lfo', 'oscillator'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The computed number.' } },
  params: {
    expression: {
      type: 'text',
      stage: 'structure',
      label: 'Expression',
      doc: 'The expression, such as: a + sin(time * tau) * b',
      default: 'a',
      expression: { names: ['a', 'b', 'c', 'd'] },
    },
    a: { type: 'number', stage: 'uniform', label: 'A', doc: 'The value of a.', default: 0 },
    b: { type: 'number', stage: 'uniform', label: 'B', doc: 'The value of b.', default: 0 },
    c: { type: 'number', stage: 'uniform', label: 'C', doc: 'The value of c.', default: 0 },
    d: { type: 'number', stage: 'uniform', label: 'D', doc: 'The value of d.', default: 0 },
  },
  computes: { result: 'expression' },
  lowering: { kind: 'value' },
});
