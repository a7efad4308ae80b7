import { createContactShadow } from './contact-shadow.ts';
import type { LightShadow, ShadowFilter } from './light-shadow.ts';
import type { DirectionalLightItem, LightList } from './scene-lists.ts';
import type { Writable } from './value-views.ts';

/** The values of `SUN_SHADOW` (`light-params.ts`) and whether there are shadows at all. */
interface SunShadowContext {
  readonly params: Readonly<Record<'areaM' | 'biasPx' | 'sourceRad' | 'contact', { readonly value: number }>> & {
    readonly castShadow: { readonly value: boolean };
  };
  readonly config: { readonly mapSize: string; readonly filter: ShadowFilter };
  readonly outputs: { readonly lights: LightList };
}

/** The shadows of parallel light, with those where things touch. */
export interface SunShadow {
  /** Once per frame, when the light's radiance is known. */
  update(light: DirectionalLightItem): void;
}

export function createSunShadow({ params, config, outputs }: SunShadowContext): SunShadow {
  const { castShadow, areaM, biasPx, sourceRad, contact } = params;
  const mapSizePx = Number(config.mapSize);
  const shadow: Writable<LightShadow> = { areaM: 0, mapSizePx, bias: 0, normalBiasM: 0, filter: config.filter, sourceRad: 0 };
  const contactShadow = createContactShadow(outputs.lights);
  return {
    update: (light) => {
      shadow.areaM = areaM.value;
      shadow.sourceRad = sourceRad.value;
      // The receivers' offset along the normal alone keeps surfaces from shadowing themselves: it has to match the reach of the
      // shadow's filter, so it is counted in the map's pixels.
      shadow.normalBiasM = (biasPx.value * areaM.value) / mapSizePx;
      light.shadow = castShadow.value ? shadow : null;
      contactShadow.update(castShadow.value ? contact.value : 0, areaM.value, light.radiance);
    },
  };
}
