import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

const NOTHING_TO_FALL_ON = {
  code: 'SCR015',
  severity: 'warning',
  port: 'receivers',
  message: 'Neither “Falls on” nor “Room depth” has a wire: there is nothing that shadows could fall on.',
  fix: 'Wire Real planes, Room depth or phantoms to it.',
} as const;

const VOLUMES_FALL_ON_NOTHING = {
  code: 'SCR015',
  severity: 'warning',
  port: 'receivers',
  message: '“Falls on” has no wire, and shadow volumes do not fall on what room depth shows: it only cuts them off.',
  fix: 'Wire Real planes or phantoms to it, or choose “Shadow map” as the method.',
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
      if (receivers.length === 0) {
        if (!depth) ctx.report(NOTHING_TO_FALL_ON);
        else if (method === 'volume') ctx.report(VOLUMES_FALL_ON_NOTHING);
      }
      scene.update(receivers, ctx.inputs.lights);
    },
    draw: scene.draw,
    dispose: scene.dispose,
  };
}
