import { describe, expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

describe('gate', () => {
  test('passes pulses on with all that they bring, one way or the other', () => {
    const pulse = createPulseQueue();
    const first = pulse.emit();
    first.number = 3;
    first.text = 'three';
    first.setPose(new Float32Array(16).fill(1));
    pulse.emit().number = 4;
    const { ctx, set, tick } = fakeContext(definition, { inputs: { pulse } });
    const node = create(ctx);
    node.update({} as never);
    expect([pulseNumbers(ctx.outputs.passed), pulseNumbers(ctx.outputs.stopped)]).toEqual([[3, 4], []]);
    expect(ctx.outputs.passed.at(0)).toMatchObject({ text: 'three', worldFromPose: new Float32Array(16).fill(1) });
    set('open', false);
    tick(0.1);
    node.update({} as never);
    expect([pulseNumbers(ctx.outputs.passed), pulseNumbers(ctx.outputs.stopped)]).toEqual([[], [3, 4]]);
  });
});
