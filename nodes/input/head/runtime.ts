import { writePose } from '../../kit/pose.ts';
import { setQuaternion, setRigid, turnToward } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const position = new Float64Array(3);
  const rotation = new Float64Array(4);
  const other = new Float64Array(4);
  const worldFromHead = new Float32Array(16);
  return {
    update: (frame) => {
      const first = frame.views[0];
      if (!first || !writeViewerPosition(position, frame)) {
        writePose(ctx.outputs.pose, null, frame.jumps);
        return;
      }
      setQuaternion(rotation, first.worldFromView);
      const second = frame.viewCount > 1 ? frame.views[1] : undefined;
      if (second) {
        // The displays of some headsets are turned outwards.
        setQuaternion(other, second.worldFromView);
        turnToward(rotation, other, 0.5);
      }
      setRigid(worldFromHead, position, rotation);
      writePose(ctx.outputs.pose, worldFromHead, frame.jumps);
    },
    dispose: () => {},
  };
}
