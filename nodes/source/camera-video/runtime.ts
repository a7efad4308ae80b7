import { MAY_CHANGE, type NodeContext, type NodeRuntime } from '../../kit/runtime.ts';
import { createColorTexture } from './color-texture.ts';
import type { definition } from './definition.ts';

/** The identity as UV matrix of the fallback texture, which is a single pixel. */
const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { views } = ctx.outputs.layer;
  const standIn = ctx.config.withoutImage === 'color' ? createColorTexture(ctx.gl) : null;
  return {
    update: (frame) => {
      for (let i = 0; i < views.length; i++) {
        const view = views[i];
        const image = i < frame.viewCount ? frame.views[i]?.cameraImage : null;
        if (!view) continue;
        view.texture = image?.texture ?? standIn?.paint(ctx.params.color.value) ?? null;
        view.widthPx = image?.widthPx ?? 1;
        view.heightPx = image?.heightPx ?? 1;
        view.uvFromViewUv.set(image?.uvFromViewUv ?? UPRIGHT);
        // A camera gives no sign of a new image, a recording does.
        view.version = image ? (frame.version ?? MAY_CHANGE) : (standIn?.version ?? 0);
      }
    },
    dispose: () => standIn?.dispose(),
  };
}
