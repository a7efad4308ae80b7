import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('splits a pose into position and -z, and rests while it is invalid', () => {
  const pose = createPose();
  const { ctx } = fakeContext(definition, { inputs: { pose } });
  const node = create(ctx);
  const step = () => {
    node.update({} as never);
    const { position, forward, valid } = ctx.outputs;
    return [[...position.value], [...forward.value].map((x) => Math.round(x * 1e6) / 1e6 + 0), valid.value];
  };
  const REST = [[0, 0, 0], [0, 0, -1], false];
  expect(step()).toEqual(REST);
  const matrix = new Float32Array(16);
  // A quarter turn to the left.
  setFromAngles(matrix, [1, 2, 3], [0, Math.PI / 2, 0]);
  writePose(pose, matrix, 0);
  expect(step()).toEqual([[1, 2, 3], [-1, 0, 0], true]);
  writePose(pose, null, 0);
  expect(step()).toEqual(REST);
});
