import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('moves and turns a pose along its own axes', () => {
  const pose = createPose();
  const { ctx } = fakeContext(definition, { params: { offsetM: [0, 0, -1], rotationRad: [0, Math.PI / 2, 0] }, inputs: { pose } });
  const node = create(ctx);
  const step = () => {
    node.update({} as never);
    const { worldFromPose, valid, jumps } = ctx.outputs.pose;
    return valid ? [[...worldFromPose].map((x) => Math.round(x * 1e5) / 1e5 + 0), jumps] : null;
  };
  expect(step()).toBe(null);
  const matrix = new Float32Array(16);
  // It faces to the left: -z is -x, so 1 m ahead is (-1, 0, 0) from it. Another quarter turn makes it face +z.
  setFromAngles(matrix, [2, 1, 0], [0, Math.PI / 2, 0]);
  writePose(pose, matrix, 4);
  expect(step()).toEqual([[-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 1, 1, 0, 1], 4]);
  writePose(pose, null, 4);
  expect(step()).toBe(null);
});
