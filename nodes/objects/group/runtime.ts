import { deriveObjects } from '../../kit/derive-objects.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const derived = deriveObjects(ctx.outputs.objects, () => {});
  return {
    version: 0,
    update: () => derived.update(ctx.inputs.objects),
    dispose: () => {},
  };
}
