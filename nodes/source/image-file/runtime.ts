import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const id = ctx.assetIds.file;
  const image = id === null ? null : ctx.assets.image(id);
  const [view] = ctx.outputs.layer.views;
  return {
    update: () => {
      const picture = image?.value ?? null;
      if (!view) return;
      view.texture = picture?.texture ?? null;
      view.widthPx = picture?.widthPx ?? 0;
      view.heightPx = picture?.heightPx ?? 0;
      view.version = picture === null ? 0 : 1;
    },
    dispose: () => image?.release(),
  };
}
