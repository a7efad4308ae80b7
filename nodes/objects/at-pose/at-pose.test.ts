import { describe, expect, test } from '@jest/globals';
import { Matrix4, Object3D, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, type PoseOutput, writePose } from '../../kit/pose.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(pose: PoseOutput | null) {
  const item = { root: new Object3D(), role: 'virtual' as const, castsShadow: true, receivesShadow: true };
  const list: ObjectList = {
    version: 1,
    items: [{ ...item, key: 'a', worldFromObject: new Matrix4().makeTranslation(0, 0, -1).scale(new Vector3(2, 2, 2)) }],
  };
  const { ctx } = fakeContext(definition, { inputs: { objects: [list], pose } });
  const node = create(ctx);
  const seen = () => {
    node.update({} as never);
    return ctx.outputs.objects.items.map(({ worldFromObject }) =>
      new Vector3(1, 0, 0)
        .applyMatrix4(worldFromObject)
        .toArray()
        .map((x) => Math.round(x * 1e6) / 1e6 + 0),
    );
  };
  return { ctx, seen };
}

describe('objects/at-pose', () => {
  test('places objects on the pose, along its axes, in their size', () => {
    const pose = createPose();
    writePose(pose, new Matrix4().makeRotationY(Math.PI / 2).setPosition(5, 1, 0).elements, 0);
    // (1, 0, 0) of the object is (2, 0, -1) before the pose turns it to (-1, 0, -2).
    expect(start(pose).seen()).toEqual([[4, 1, -2]]);
  });

  test('hides them while the pose is invalid, and shows them where it is then', () => {
    const pose = createPose();
    const { ctx, seen } = start(pose);
    expect(seen()).toEqual([]);
    const { version } = ctx.outputs.objects;
    expect([seen(), ctx.outputs.objects.version]).toEqual([[], version]);
    writePose(pose, new Matrix4().makeTranslation(0, 3, 0).elements, 0);
    expect(seen()).toEqual([[2, 3, -1]]);
    writePose(pose, null, 0);
    expect(seen()).toEqual([]);
  });

  test('hides them without a pose', () => {
    expect(start(null).seen()).toEqual([]);
  });
});
