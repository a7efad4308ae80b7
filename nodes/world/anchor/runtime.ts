import type { Anchor } from '../../kit/anchors.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { inputs, outputs, session } = ctx;
  const { when } = ctx.config;
  let anchor: Anchor | null = null;
  /** The input pose was valid in the previous frame. */
  let wasValid = false;
  let lastSession = session.sessions;
  /** Anchors so far. */
  let made = 0;
  let jumps = 0;
  let frameJumps = 0;

  function clear(): void {
    anchor?.delete();
    anchor = null;
  }

  function anchorAt(worldFromPose: ArrayLike<number>): void {
    clear();
    anchor = session.anchors.create(worldFromPose);
    made++;
  }

  /** The pose of the last pulse at `set`, or of the input, if one is there. */
  function setPose(): ArrayLike<number> | null {
    const { pose, set } = inputs;
    if (set.count === 0) return null;
    if (pose) return pose.valid ? pose.worldFromPose : null;
    return set.at(set.count - 1).worldFromPose;
  }

  return {
    update: (frame) => {
      const { pose } = inputs;
      if (session.sessions !== lastSession) {
        // The room of the last session is gone, and its anchors with it.
        clear();
        wasValid = false;
      }
      lastSession = session.sessions;
      if (frame.jumps !== frameJumps) jumps++;
      frameJumps = frame.jumps;
      if (inputs.clear.count > 0) clear();
      const isValid = pose?.valid ?? false;
      const asked = setPose();
      if (asked) anchorAt(asked);
      else if (pose && isValid && !wasValid && when === 'valid') anchorAt(pose.worldFromPose);
      wasValid = isValid;
      writePose(outputs.pose, anchor?.worldFromAnchor ?? null, jumps + made);
      outputs.state.value = anchor?.state ?? '';
      outputs.tracked.value = anchor?.state === 'tracked';
    },
    reset: () => {
      clear();
      wasValid = false;
      made = 0;
      jumps = 0;
      frameJumps = 0;
    },
    dispose: clear,
  };
}
