import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime, PulseOutput } from '../../kit/runtime.ts';
import type { Controller } from '../../kit/session.ts';
import type { definition } from './definition.ts';

/**
 * How far the trigger must be pulled to count as pulled; it then counts as released only below `LET_GO`. Two thresholds (hysteresis)
 * prevent that a finger at rest in the middle triggers repeatedly.
 */
const PULLED = 0.5;
const LET_GO = 0.4;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { hand } = ctx.config;
  const { inputs, outputs } = ctx;
  let wasPulled = false;
  let hadPrimary = false;
  let hadSecondary = false;
  let hadStick = false;
  /** The controller whose poses the outputs had last; `changes` counts how often it has changed. */
  let lastPosed: Controller | null = null;
  let changes = 0;

  const push = ({ stick }: Controller): number => Math.hypot(stick[0] ?? 0, stick[1] ?? 0);

  /** Writes the stick to the outputs, rescaled to be 0 at the edge of the dead zone and 1 at the end. */
  function writeStick(controller: Controller): void {
    const pushed = push(controller);
    const dead = Math.min(Math.max(ctx.params.deadZone.value, 0), 0.99);
    const scale = pushed <= dead ? 0 : Math.min((pushed - dead) / (1 - dead), 1) / pushed;
    outputs.x.value = (controller.stick[0] ?? 0) * scale;
    outputs.y.value = (controller.stick[1] ?? 0) * scale;
  }

  function writePoses(posed: Controller, frameJumps: number): void {
    if (lastPosed !== null && posed !== lastPosed) changes++;
    lastPosed = posed;
    writePose(outputs.ray, posed.worldFromRay, frameJumps + changes);
    writePose(outputs.grip, posed.worldFromGrip, frameJumps + changes);
  }

  function vibrate(one: Controller, other: Controller): void {
    if (inputs.vibrate.count === 0) return;
    const { strength, durationS } = ctx.params;
    one.haptics?.pulse(strength.value, durationS.value);
    if (other.haptics !== one.haptics) other.haptics?.pulse(strength.value, durationS.value);
  }

  return {
    update: ({ input, jumps }) => {
      const one = hand === 'right' ? input.right : input.left;
      const other = hand === 'left' ? input.left : input.right;
      writePoses(other.worldFromRay ? other : one, jumps);
      vibrate(one, other);
      const firm = one.trigger >= other.trigger ? one : other;
      writeStick(push(one) >= push(other) ? one : other);
      outputs.trigger.value = firm.trigger;
      outputs.squeeze.value = Math.max(one.squeeze, other.squeeze);
      outputs.connected.value = one.connected || other.connected;

      const pulled = firm.trigger >= (wasPulled ? LET_GO : PULLED);
      const primary = one.primary || other.primary;
      const secondary = one.secondary || other.secondary;
      if (pulled && !wasPulled) point(outputs.pulled, firm);
      if (primary && !hadPrimary) point(outputs.primary, one.primary ? one : other);
      if (secondary && !hadSecondary) point(outputs.secondary, one.secondary ? one : other);
      const stick = one.stickPressed || other.stickPressed;
      if (stick && !hadStick) point(outputs.stickPressed, one.stickPressed ? one : other);
      wasPulled = pulled;
      hadPrimary = primary;
      hadSecondary = secondary;
      hadStick = stick;
    },
    reset: () => {
      wasPulled = false;
      hadPrimary = false;
      hadSecondary = false;
      hadStick = false;
      lastPosed = null;
      changes = 0;
    },
    dispose: () => {},
  };
}

function point(output: PulseOutput, { worldFromRay }: Controller): void {
  const pulse = output.emit();
  if (worldFromRay) pulse.setPose(worldFromRay);
}
