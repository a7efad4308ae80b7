import { describe, expect, test } from '@jest/globals';
import { parseExpression } from '../../../export/graph/expression/expression-parser.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** As the compiler hands it over. */
function start(text: string, params: { a?: number; b?: number } = {}) {
  const parsed = parseExpression(text, 1, definition.params.expression.expression.names);
  if (!parsed.ok) throw new Error(parsed.message);
  const made = fakeContext(definition, { params: { expression: parsed.parts.join(' '), ...params } });
  const { update } = create(made.ctx);
  return {
    ...made,
    result: () => {
      update({} as never);
      return made.ctx.outputs.result.value;
    },
  };
}

describe('value/expression', () => {
  test('computes from its numbers in each frame', () => {
    const { result, set } = start('a + b * 2', { a: 1, b: 2 });
    expect(result()).toBe(5);
    set('b', 10);
    expect(result()).toBe(21);
  });

  test('reads the time and the frame', () => {
    const { result, tick } = start('time * 100 + frame');
    expect(result()).toBe(0);
    tick(0.5);
    expect(result()).toBe(51);
  });

  test.each(['1 / a', 'sqrt(-1)', 'log(0)', '0 / 0'])('%s gives 0, not something that would spread', (text) => {
    expect(start(text).result()).toBe(0);
  });

  test('every name of expressions is a param of the node', () => {
    const { names } = definition.params.expression.expression;
    for (const name of names) expect(definition.params[name]).toMatchObject({ type: 'number', stage: 'uniform' });
  });
});
