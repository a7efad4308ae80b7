import { Color } from 'three';
import { createContactShadow } from '../../kit/contact-shadow.ts';
import type { LightShadow } from '../../kit/light-shadow.ts';
import type { DirectionalLightItem, NodeContext, NodeRuntime, Writable } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** A matt surface sends back 1/π of the light that meets it: this much light makes a white one white. */
const WHITE_ON_WHITE = Math.PI;

// Read by the call that fills it, before anything else can.
const scratchColor = new Color();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { color, intensity, azimuthRad, elevationRad, castShadow, areaM, biasPx, sourceRad, contact } = ctx.params;
  const mapSizePx = Number(ctx.config.mapSize);
  // The receivers' offset along the normal alone keeps surfaces from shadowing themselves: it has to match the reach of the
  // shadow's filter, so it is counted in the map's pixels.
  const shadow: Writable<LightShadow> = { areaM: 0, mapSizePx, bias: 0, normalBiasM: 0, filter: ctx.config.filter, sourceRad: 0 };
  const light: DirectionalLightItem = {
    key: 'light',
    kind: 'directional',
    radiance: new Float32Array(3),
    towardsLightWorld: new Float32Array(3),
    shadow: null,
  };
  ctx.outputs.lights.items.push(light);
  ctx.outputs.lights.version++;
  const contactShadow = createContactShadow(ctx.outputs.lights);

  return {
    update: () => {
      scratchColor.fromArray(color.value).convertSRGBToLinear();
      scratchColor.multiplyScalar(intensity.value * WHITE_ON_WHITE).toArray(light.radiance);
      const horizontal = Math.cos(elevationRad.value);
      light.towardsLightWorld[0] = horizontal * Math.sin(azimuthRad.value);
      light.towardsLightWorld[1] = Math.sin(elevationRad.value);
      light.towardsLightWorld[2] = horizontal * Math.cos(azimuthRad.value);
      shadow.areaM = areaM.value;
      shadow.sourceRad = sourceRad.value;
      shadow.normalBiasM = (biasPx.value * areaM.value) / mapSizePx;
      light.shadow = castShadow.value ? shadow : null;
      contactShadow.update(castShadow.value ? contact.value : 0, areaM.value, light.radiance);
    },
    dispose: () => {},
  };
}
