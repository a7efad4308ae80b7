import { Color, Vector3 } from 'three';
import type { LocalLightShadow } from '../../kit/light-shadow.ts';
import { createSpotItem } from '../../kit/local-lights.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

// Filled and read within one call.
const scratchColor = new Color();
const scratchTowards = new Vector3();
const scratchTarget = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { color, intensityCd, positionM, targetM, angleRad, penumbra, rangeM, castShadow, biasPx, sourceM } = ctx.params;
  const shadow: LocalLightShadow = { mapSizePx: Number(ctx.config.mapSize), biasPx: 0, filter: ctx.config.filter, sourceM: 0 };
  const light = createSpotItem('light');
  ctx.outputs.lights.items.push(light);
  ctx.outputs.lights.version++;

  return {
    version: 0,
    update: () => {
      scratchColor.fromArray(color.value).convertSRGBToLinear().multiplyScalar(intensityCd.value).toArray(light.intensityCd);
      light.positionWorld.set(positionM.value);
      scratchTowards.fromArray(positionM.value).sub(scratchTarget.fromArray(targetM.value));
      // A light that is aimed at its own position shines down.
      if (scratchTowards.lengthSq() < 1e-12) scratchTowards.set(0, 1, 0);
      scratchTowards.normalize().toArray(light.towardsLightWorld);
      light.halfAngleRad = angleRad.value / 2;
      light.penumbra = penumbra.value;
      light.rangeM = rangeM.value;
      shadow.biasPx = biasPx.value;
      shadow.sourceM = sourceM.value;
      light.shadow = castShadow.value ? shadow : null;
    },
    dispose: () => {},
  };
}
