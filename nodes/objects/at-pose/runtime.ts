import { Matrix4 } from 'three';
import { deriveObjects } from '../../kit/derive-objects.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const worldFromPose = new Matrix4();
  const derived = deriveObjects(ctx.outputs.objects, (item) => {
    item.worldFromObject.premultiply(worldFromPose);
  });
  return {
    version: 0,
    update: () => {
      const { pose, objects } = ctx.inputs;
      if (pose) worldFromPose.fromArray(pose.worldFromPose);
      derived.update(objects, pose?.valid ?? false);
    },
    dispose: () => {},
  };
}
