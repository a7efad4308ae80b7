import { Color } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DirectionalLightItem } from '../../kit/scene-lists.ts';
import { createSunShadow } from '../../kit/sun-shadow.ts';
import type { definition } from './definition.ts';

/** The irradiance that renders a white matte surface as white: such a surface reflects 1/π of the irradiance. */
const WHITE_ON_WHITE = Math.PI;

// Filled and read within one call.
const scratchColor = new Color();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { color, intensity, azimuthRad, elevationRad } = ctx.params;
  const light: DirectionalLightItem = {
    key: 'light',
    kind: 'directional',
    radiance: new Float32Array(3),
    towardsLightWorld: new Float32Array(3),
    shadow: null,
  };
  ctx.outputs.lights.items.push(light);
  ctx.outputs.lights.version++;
  const shadow = createSunShadow(ctx);

  return {
    version: 0,
    update: () => {
      scratchColor.fromArray(color.value).convertSRGBToLinear();
      scratchColor.multiplyScalar(intensity.value * WHITE_ON_WHITE).toArray(light.radiance);
      const horizontal = Math.cos(elevationRad.value);
      light.towardsLightWorld[0] = horizontal * Math.sin(azimuthRad.value);
      light.towardsLightWorld[1] = Math.sin(elevationRad.value);
      light.towardsLightWorld[2] = horizontal * Math.cos(azimuthRad.value);
      shadow.update(light);
    },
    dispose: () => {},
  };
}
