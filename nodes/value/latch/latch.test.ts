import { expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('holds the sampled number until the next pulse or a reset', () => {
  const take = createPulseQueue();
  const { ctx, set } = fakeContext(definition, { params: { number: 5, start: -1 }, inputs: { take } });
  const node = create(ctx);
  const next = (): number => {
    node.update({} as never);
    take.clear();
    return ctx.outputs.result.value;
  };
  expect(next()).toBe(-1);
  take.emit();
  expect(next()).toBe(5);
  set('number', 8);
  expect(next()).toBe(5);
  take.emit();
  take.emit();
  expect(next()).toBe(8);
  node.reset?.();
  expect(next()).toBe(-1);
});
