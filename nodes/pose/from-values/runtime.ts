import { writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { positionM, rotationRad } = ctx.params;
  const worldFromPose = new Float32Array(16);
  return {
    update: ({ jumps }) => {
      setFromAngles(worldFromPose, positionM.value, rotationRad.value);
      writePose(ctx.outputs.pose, worldFromPose, jumps);
    },
    dispose: () => {},
  };
}
