import { describe, expect, test } from '@jest/globals';
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Vector = readonly [number, number, number];

function start() {
  const poses = { from: createPose(), to: createPose() };
  const { ctx } = fakeContext(definition, { inputs: poses });
  const node = create(ctx);
  const stand = (which: keyof typeof poses, at: Vector | null, turn: Vector = [0, 0, 0]) => {
    const matrix = at && new Matrix4().compose(new Vector3(...at), new Quaternion().setFromEuler(new Euler(...turn)), new Vector3(1, 1, 1));
    writePose(poses[which], matrix?.elements ?? null, 0);
  };
  const read = () => {
    node.update({} as never);
    const { distanceM, levelM, heightM, valid } = ctx.outputs;
    return { distanceM: distanceM.value, levelM: levelM.value, heightM: heightM.value, valid: valid.value };
  };
  return { stand, read };
}

describe('pose/distance', () => {
  test('gives the sides of a triangle', () => {
    const { stand, read } = start();
    stand('from', [1, 2, 3]);
    // 3 and 4 on the level are 5; 5 and 12 upwards are 13.
    stand('to', [4, 14, 7]);
    expect(read()).toEqual({ distanceM: 13, levelM: 5, heightM: 12, valid: true });
    stand('to', [1, 1.5, 3]);
    expect(read()).toEqual({ distanceM: 0.5, levelM: 0, heightM: -0.5, valid: true });
  });

  test('agrees with three.js, however the poses are turned', () => {
    const { stand, read } = start();
    for (let i = 0; i < 50; i++) {
      const from: Vector = [Math.sin(i) * 3, Math.cos(2 * i), Math.sin(5 * i) * 8];
      const to: Vector = [Math.cos(3 * i) * 2, Math.sin(7 * i), Math.cos(i) * 6];
      stand('from', from, [i, 2 * i, 3 * i]);
      stand('to', to, [-i, i / 2, 0]);
      expect(read().distanceM).toBeCloseTo(new Vector3(...from).distanceTo(new Vector3(...to)), 5);
    }
  });

  test.each(['from', 'to'] as const)('is 0 and not valid while “%s” is invalid', (which) => {
    const { stand, read } = start();
    stand('from', [0, 0, 0]);
    stand('to', [0, 3, 4]);
    expect(read().distanceM).toBe(5);
    stand(which, null);
    expect(read()).toEqual({ distanceM: 0, levelM: 0, heightM: 0, valid: false });
    stand(which, [0, 0, 0]);
    expect(read().valid).toBe(true);
  });
});
