import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs } = ctx;
  const position = new Float64Array(3);
  const forward = new Float64Array(3);
  return {
    update: () => {
      const { pose } = ctx.inputs;
      const valid = pose?.valid ?? false;
      position.fill(0);
      forward.fill(0);
      forward[2] = -1;
      if (pose && valid) {
        for (let i = 0; i < 3; i++) {
          position[i] = pose.worldFromPose[12 + i] ?? 0;
          forward[i] = -(pose.worldFromPose[8 + i] ?? 0);
        }
      }
      outputs.position.value = position;
      outputs.forward.value = forward;
      outputs.valid.value = valid;
    },
    dispose: () => {},
  };
}
