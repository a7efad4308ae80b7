import { Color } from 'three';
import type { LocalLightShadow } from '../../kit/light-shadow.ts';
import { createPointItem } from '../../kit/local-lights.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

// Filled and read within one call.
const scratchColor = new Color();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { color, intensityCd, positionM, rangeM, castShadow, biasPx } = ctx.params;
  const shadow: LocalLightShadow = { mapSizePx: Number(ctx.config.mapSize), biasPx: 0, filter: ctx.config.filter };
  const light = createPointItem('light');
  ctx.outputs.lights.items.push(light);
  ctx.outputs.lights.version++;

  return {
    version: 0,
    update: () => {
      scratchColor.fromArray(color.value).convertSRGBToLinear().multiplyScalar(intensityCd.value).toArray(light.intensityCd);
      light.positionWorld.set(positionM.value);
      light.rangeM = rangeM.value;
      shadow.biasPx = biasPx.value;
      light.shadow = castShadow.value ? shadow : null;
    },
    dispose: () => {},
  };
}
