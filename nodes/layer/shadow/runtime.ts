import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

const NOTHING_TO_FALL_ON = {
  code: 'SCR015',
  severity: 'warning',
  port: 'receivers',
  message: 'Neither “Falls on” nor “Room depth” has a wire: there is nothing that shadows could fall on.',
  fix: 'Wire Real planes, Room depth or phantoms to it.',
} as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { strength, color, toleranceM } = ctx.params;
  const { depth, receivers } = ctx.inputs;
  const { on, method } = ctx.config;
  const volumes = method === 'volume' ? { volumesOf: ctx.inputs.casters } : {};
  const room = depth ? { room: { depth, toleranceM } } : {};
  const scene = ctx.scenes.createScene({ kind: 'shadow-catcher', strength, color, on, ...volumes, ...room });
  return {
    update: () => {
      if (!depth && receivers.length === 0) ctx.report(NOTHING_TO_FALL_ON);
      scene.update(receivers, ctx.inputs.lights);
    },
    draw: scene.draw,
    dispose: scene.dispose,
  };
}
