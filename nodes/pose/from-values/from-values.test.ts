import { expect, test } from '@jest/globals';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('makes a pose that follows its values and jumps with world space', () => {
  const { ctx, set } = fakeContext(definition, { params: { positionM: [1, 2, 3], rotationRad: [Math.PI / 2, 0, 0] } });
  const node = create(ctx);
  const frame = { ...createSessionFrame(), jumps: 2 };
  node.update(frame);
  const { pose } = ctx.outputs;
  // A quarter turn about x: y is z, and z is -y.
  expect([...pose.worldFromPose].map((x) => Math.round(x * 1e6) / 1e6 + 0)).toEqual([1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 1, 2, 3, 1]);
  expect([pose.valid, pose.jumps]).toEqual([true, 2]);
  set('positionM', [4, 5, 6]);
  node.update(frame);
  expect([...pose.worldFromPose.slice(12, 15)]).toEqual([4, 5, 6]);
  set('positionM', [Number.NaN, 0, 0]);
  node.update(frame);
  expect(pose.valid).toBe(false);
});
