import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { rotationRad, exposure } = ctx.params;
  const { environment } = ctx.outputs;
  const id = ctx.assetIds.file;
  const panorama = id === null ? null : ctx.assets.environment(id);
  return {
    get version() {
      return environment.asset === null ? 0 : 1;
    },
    update: () => {
      environment.asset = panorama?.value ?? null;
      environment.intensity = 2 ** exposure.value;
      environment.rotationRad = rotationRad.value;
    },
    dispose: () => panorama?.release(),
  };
}
