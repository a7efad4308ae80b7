import type { Anchor } from '../../kit/anchors.ts';
import { isPose, writePose } from '../../kit/pose.ts';
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
  /** Whether the input pose was valid in the previous frame. */
  let wasValid = false;
  let lastSession = session.sessions;
  /** The number of anchors so far; each raises `jumps` of the output. */
  let made = 0;
  let jumps = 0;
  let frameJumps = 0;
  /** Whether the anchor of an earlier visit has been asked for in this session. */
  let isRecalled = false;
  /** Whether the anchor comes from an earlier visit. If so, a pose that becomes valid does not replace it. */
  let isRestored = false;
  /** Whether the device has not yet found the anchor of an earlier visit, which then has no pose. */
  let isAwaited = false;
  /** Whether the visitor has been told if the device keeps the anchor. */
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

  /** Checks whether the device has found the anchor of an earlier visit, or has lost it for good. */
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

  /**
   * The pose for which a pulse at `set` asks an anchor: the input pose if one is connected, otherwise that of the last pulse. Null if there
   * is no pulse or no valid pose.
   */
  function setPose(): ArrayLike<number> | null {
    const { pose, set } = inputs;
    if (set.count === 0) return null;
    if (pose) return pose.valid ? pose.worldFromPose : null;
    const { worldFromPose } = set.at(set.count - 1);
    // A node may emit what is no pose, such as NaN.
    return worldFromPose && isPose(worldFromPose) ? worldFromPose : null;
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
