import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';
import { createMaskFigures, measureMask } from './measure.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs, params } = ctx;
  const figures = createMaskFigures();
  const rule = { source: 0, threshold: 0, regionMin: params.regionMin.value, regionMax: params.regionMax.value };
  let isInside = false;

  function clear(): void {
    figures.area = 0;
    figures.center.fill(0.5);
    figures.boxMin.fill(0);
    figures.boxMax.fill(0);
    isInside = false;
  }

  return {
    update: () => {
      const pixels = ctx.inputs.mask?.read() ?? null;
      if (pixels) {
        rule.source = params.source.value;
        rule.threshold = params.threshold.value;
        rule.regionMin = params.regionMin.value;
        rule.regionMax = params.regionMax.value;
        measureMask(figures, pixels, rule);
      }
      const { area, center, boxMin, boxMax } = figures;
      outputs.area.value = area;
      outputs.center.value = center;
      outputs.boxMin.value = boxMin;
      outputs.boxMax.value = boxMax;
      const wasInside = isInside;
      isInside = area > 0 && area >= (wasInside ? params.leaveArea.value : params.enterArea.value);
      outputs.inside.value = isInside;
      if (isInside !== wasInside) (isInside ? outputs.entered : outputs.left).emit().number = area;
    },
    reset: clear,
    dispose: () => {},
  };
}
