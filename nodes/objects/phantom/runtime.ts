import { deriveObjects } from '../../kit/derive-objects.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { castShadow, receiveShadow } = ctx.params;
  const derived = deriveObjects(ctx.outputs.objects, (item) => {
    item.role = 'phantom';
    item.castsShadow = castShadow.value;
    item.receivesShadow = receiveShadow.value;
  });
  return {
    version: 0,
    update: () => derived.update(ctx.inputs.objects),
    dispose: () => {},
  };
}
