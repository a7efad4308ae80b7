import { writePose } from '../../kit/pose.ts';
import { aimZ } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { upright } = ctx.params;
  const sign = ctx.config.front === 'z' ? 1 : -1;
  const worldFromPose = new Float32Array(16);
  return {
    update: () => {
      const { pose, target } = ctx.inputs;
      const jumps = (pose?.jumps ?? 0) + (target?.jumps ?? 0);
      if (!pose?.valid || !target?.valid) {
        writePose(ctx.outputs.pose, null, jumps);
        return;
      }
      worldFromPose.set(pose.worldFromPose);
      const along = (i: number) => sign * ((target.worldFromPose[i] ?? 0) - (worldFromPose[i] ?? 0));
      aimZ(worldFromPose, along(12), upright.value ? 0 : along(13), along(14));
      writePose(ctx.outputs.pose, worldFromPose, jumps);
    },
    dispose: () => {},
  };
}
