import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const scene = ctx.scenes.createScene({ kind: 'shaded', ambient: ctx.params.ambient, encoding: ctx.config.encoding });
  return {
    version: 0,
    update: () => scene.update(ctx.inputs.objects, ctx.inputs.lights),
    draw: scene.draw,
    dispose: scene.dispose,
  };
}
