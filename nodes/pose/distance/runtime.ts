import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs } = ctx;
  return {
    update: () => {
      const { from, to } = ctx.inputs;
      const valid = from !== null && to !== null && from.valid && to.valid;
      const along = (i: number) => (valid ? (to.worldFromPose[i] ?? 0) - (from.worldFromPose[i] ?? 0) : 0);
      const x = along(12);
      const y = along(13);
      const z = along(14);
      outputs.distanceM.value = Math.hypot(x, y, z);
      outputs.levelM.value = Math.hypot(x, z);
      outputs.heightM.value = y;
      outputs.valid.value = valid;
    },
    dispose: () => {},
  };
}
