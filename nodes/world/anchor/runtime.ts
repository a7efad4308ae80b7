import type { Anchor } from '../../kit/anchors.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

const EVICTED = {
  code: 'SCR057',
  severity: 'warning',
  message: 'The device keeps no more anchors. It has forgotten the oldest one to keep this one.',
} as const;
const REFUSED = {
  code: 'SCR057',
  severity: 'info',
  message: 'The device does not keep the anchor for later visits.',
} as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { inputs, outputs, session } = ctx;
  const { when, keep } = ctx.config;
  let anchor: Anchor | null = null;
  /** The input pose was valid in the previous frame. */
  let wasValid = false;
  let lastSession = session.sessions;
  /** Anchors so far. */
  let made = 0;
  let jumps = 0;
  let frameJumps = 0;
  /** What an earlier visit kept has been asked for in this session. */
  let isRecalled = false;
  /** The anchor comes from an earlier visit: a pose that becomes valid does not replace it. */
  let isRestored = false;
  /** The device has not found it yet, so it has no pose. */
  let isAwaited = false;
  /** The visitor has been told what became of the wish to keep it. */
  let isTold = false;

  function drop(): void {
    anchor?.delete();
    anchor = null;
    isRestored = false;
    isAwaited = false;
  }

  function anchorAt(worldFromPose: ArrayLike<number>): void {
    drop();
    anchor = keep ? session.anchors.create(worldFromPose, ctx.node) : session.anchors.create(worldFromPose);
    isTold = false;
    made++;
  }

  function recall(): void {
    isRecalled = true;
    anchor = session.anchors.restore(ctx.node);
    isRestored = anchor !== null;
    isAwaited = isRestored;
  }

  /** Follows an anchor of an earlier visit until the device has found it. */
  function awaitPlace(): void {
    if (anchor?.state === 'deleted') {
      drop();
      // A pose that is valid already is anchored instead.
      wasValid = false;
    } else if (anchor?.state === 'tracked') {
      isAwaited = false;
      made++;
    }
  }

  function tell({ keeping, evicted }: Anchor): void {
    if (isTold || keeping === 'pending') return;
    isTold = true;
    if (evicted > 0) ctx.report(EVICTED);
    else if (keeping === 'refused') ctx.report(REFUSED);
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
        drop();
        wasValid = false;
        isRecalled = false;
      }
      lastSession = session.sessions;
      if (frame.jumps !== frameJumps) jumps++;
      frameJumps = frame.jumps;
      if (keep && !isRecalled) recall();
      if (isAwaited) awaitPlace();
      if (inputs.clear.count > 0) {
        drop();
        if (keep) session.anchors.forget(ctx.node);
      }
      const isValid = pose?.valid ?? false;
      const asked = setPose();
      if (asked) anchorAt(asked);
      else if (pose && isValid && !wasValid && when === 'valid' && !isRestored) anchorAt(pose.worldFromPose);
      wasValid = isValid;
      if (keep && anchor) tell(anchor);
      writePose(outputs.pose, isAwaited ? null : (anchor?.worldFromAnchor ?? null), jumps + made);
      outputs.state.value = anchor?.state ?? '';
      outputs.tracked.value = anchor?.state === 'tracked';
      outputs.kept.value = anchor?.keeping === 'kept';
    },
    staysOnRepeat: true,
    reset: () => {
      drop();
      wasValid = false;
      isRecalled = false;
      made = 0;
      jumps = 0;
      frameJumps = 0;
    },
    dispose: drop,
  };
}
