import { multiplyMatrices } from '../../kit/matrices.ts';
import { writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { offsetM, rotationRad } = ctx.params;
  const oldFromNew = new Float32Array(16);
  const worldFromNew = new Float32Array(16);
  return {
    update: () => {
      const { pose } = ctx.inputs;
      if (!pose?.valid) {
        writePose(ctx.outputs.pose, null, pose?.jumps ?? 0);
        return;
      }
      setFromAngles(oldFromNew, offsetM.value, rotationRad.value);
      multiplyMatrices(worldFromNew, pose.worldFromPose, oldFromNew);
      writePose(ctx.outputs.pose, worldFromNew, pose.jumps);
    },
    dispose: () => {},
  };
}
