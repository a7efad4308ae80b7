import { describe, expect, test } from '@jest/globals';
import { createSessionInput, nextTap } from '../../../export/runtime/sessions/input/session-input.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import type { Tap } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** A ray from (1, 2, 3) along -x. */
const RAY = [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1];

function start(by: (typeof definition.params.by.options)[number]['value'] = 'any') {
  const fake = fakeContext(definition, { params: { by, distanceM: 2, start: [9, 9, 9] } });
  const node = create(fake.ctx);
  const input = createSessionInput();
  const frame = (...taps: Tap['by'][]): number[] => {
    input.tapCount = 0;
    for (const from of taps) {
      const tap = nextTap(input);
      if (!tap) continue;
      tap.by = from;
      tap.worldFromRay.set(RAY);
    }
    fake.tick(1 / 60);
    node.update({ input } as never);
    return pulseNumbers(fake.ctx.outputs.tapped);
  };
  return { ...fake, node, frame };
}

describe('tap', () => {
  test('gives a pulse per tap, with its ray', () => {
    const { ctx, frame } = start();
    expect([frame(), frame('screen'), frame('left', 'other'), frame()]).toEqual([[], [1], [2, 3], []]);
    frame('screen');
    expect([...(ctx.outputs.tapped.at(0).worldFromPose ?? [])]).toEqual(RAY);
  });

  test('reports only the selected kinds of taps', () => {
    const by = (which: 'screen' | 'hands') => start(which).frame('screen', 'left', 'right', 'other', 'screen').length;
    expect([by('screen'), by('hands')]).toEqual([2, 3]);
  });

  test('points so far along the last ray, and to its start before there is one', () => {
    const { ctx, node, frame, set } = start();
    frame();
    expect([...ctx.outputs.point.value]).toEqual([9, 9, 9]);
    frame('screen');
    expect([...ctx.outputs.point.value]).toEqual([-1, 2, 3]);
    set('distanceM', 0.5);
    frame();
    expect([...ctx.outputs.point.value]).toEqual([0.5, 2, 3]);
    node.reset?.();
    expect([frame('screen'), [...ctx.outputs.point.value]]).toEqual([[1], [0.5, 2, 3]]);
  });
});
