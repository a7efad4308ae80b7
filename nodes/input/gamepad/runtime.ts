import type { NodeContext, NodeRuntime, PulseOutput } from '../../kit/runtime.ts';
import type { Controller } from '../../kit/session.ts';
import type { definition } from './definition.ts';

/** Two thresholds (hysteresis), so that a finger that rests in the middle does not trigger repeatedly. */
const PULLED = 0.5;
const LET_GO = 0.4;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { hand } = ctx.config;
  const { outputs } = ctx;
  let wasPulled = false;
  let hadPrimary = false;
  let hadSecondary = false;

  const push = ({ stick }: Controller): number => Math.hypot(stick[0] ?? 0, stick[1] ?? 0);

  /** Rescales the stick so that it is 0 at the edge of the dead zone and 1 at the end. */
  function writeStick(controller: Controller): void {
    const pushed = push(controller);
    const dead = Math.min(Math.max(ctx.params.deadZone.value, 0), 0.99);
    const scale = pushed <= dead ? 0 : Math.min((pushed - dead) / (1 - dead), 1) / pushed;
    outputs.x.value = (controller.stick[0] ?? 0) * scale;
    outputs.y.value = (controller.stick[1] ?? 0) * scale;
  }

  return {
    update: ({ input }) => {
      const one = hand === 'right' ? input.right : input.left;
      const other = hand === 'left' ? input.left : input.right;
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
      wasPulled = pulled;
      hadPrimary = primary;
      hadSecondary = secondary;
    },
    reset: () => {
      wasPulled = false;
      hadPrimary = false;
      hadSecondary = false;
    },
    dispose: () => {},
  };
}

function point(output: PulseOutput, { worldFromRay }: Controller): void {
  const pulse = output.emit();
  if (worldFromRay) pulse.setPose(worldFromRay);
}
