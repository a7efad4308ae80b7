import { writePose } from '../../kit/pose.ts';
import { setQuaternion, setRigid, turnToward } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { timeConstantS } = ctx.params;
  const position = new Float64Array(3);
  const rotation = new Float64Array(4);
  const towards = new Float64Array(4);
  const worldFromPose = new Float32Array(16);
  let isFollowing = false;
  let lastJumps = 0;

  return {
    update: () => {
      const { pose } = ctx.inputs;
      const jumps = pose?.jumps ?? 0;
      if (!pose?.valid) {
        isFollowing = false;
        writePose(ctx.outputs.pose, null, jumps);
        return;
      }
      const restarts = !isFollowing || jumps !== lastJumps || timeConstantS.value <= 0;
      isFollowing = true;
      lastJumps = jumps;
      setQuaternion(towards, pose.worldFromPose);
      if (restarts) {
        for (let i = 0; i < 3; i++) position[i] = pose.worldFromPose[12 + i] ?? 0;
        rotation.set(towards);
      } else {
        const part = 1 - Math.exp(-ctx.clock.deltaS / timeConstantS.value);
        for (let i = 0; i < 3; i++) position[i] = (position[i] ?? 0) + ((pose.worldFromPose[12 + i] ?? 0) - (position[i] ?? 0)) * part;
        turnToward(rotation, towards, part);
      }
      setRigid(worldFromPose, position, rotation);
      writePose(ctx.outputs.pose, worldFromPose, jumps);
    },
    reset: () => {
      isFollowing = false;
    },
    dispose: () => {},
  };
}
