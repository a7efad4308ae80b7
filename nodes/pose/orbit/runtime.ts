import { multiplyMatrices } from '../../kit/matrices.ts';
import { writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** The rotation of the pose about y, relative to the center, at the start of the orbit, where the pose is on the x axis. */
const TURN_RAD = { ahead: Math.PI, inwards: -Math.PI / 2, outwards: Math.PI / 2 } as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { radiusM, heightM, speedHz, angleRad } = ctx.params;
  const { front } = ctx.config;
  const position = new Float64Array(3);
  const rotation = new Float64Array(3);
  const centerFromPose = new Float32Array(16);
  const worldFromPose = new Float32Array(16);
  return {
    update: ({ jumps }) => {
      const { center } = ctx.inputs;
      const rad = angleRad.value + 2 * Math.PI * ((speedHz.value * ctx.clock.timeS) % 1);
      position[0] = Math.cos(rad) * radiusM.value;
      position[1] = heightM.value;
      position[2] = -Math.sin(rad) * radiusM.value;
      rotation[1] = front === 'keep' ? 0 : rad + TURN_RAD[front];
      setFromAngles(centerFromPose, position, rotation);
      if (!center) {
        writePose(ctx.outputs.pose, centerFromPose, jumps);
        return;
      }
      multiplyMatrices(worldFromPose, center.worldFromPose, centerFromPose);
      writePose(ctx.outputs.pose, center.valid ? worldFromPose : null, center.jumps);
    },
    dispose: () => {},
  };
}
