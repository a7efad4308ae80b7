import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { strength, color } = ctx.params;
  const { on, method } = ctx.config;
  const volumes = method === 'volume' ? { volumesOf: ctx.inputs.casters } : {};
  const scene = ctx.scenes.createScene({ kind: 'shadow-catcher', strength, color, on, ...volumes });
  return {
    update: () => scene.update(ctx.inputs.receivers, ctx.inputs.lights),
    draw: scene.draw,
    dispose: scene.dispose,
  };
}
