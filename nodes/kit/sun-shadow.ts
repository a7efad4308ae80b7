import { createContactShadow } from './contact-shadow.ts';
import type { LightShadow, ShadowFilter } from './light-shadow.ts';
import type { DirectionalLightItem, LightList } from './scene-lists.ts';
import type { Writable } from './value-views.ts';

/** The parts of a node context that `createSunShadow` uses; the node has the params of `SUN_SHADOW` and `castShadow`. */
interface SunShadowContext {
  readonly params: Readonly<Record<'areaM' | 'biasPx' | 'sourceRad' | 'contact', { readonly value: number }>> & {
    readonly castShadow: { readonly value: boolean };
  };
  readonly config: { readonly mapSize: string; readonly filter: ShadowFilter };
  readonly outputs: { readonly lights: LightList };
}

/** The shadow of a directional light, with its contact shadow. */
export interface SunShadow {
  /** Updates both shadows. Call it once per frame, after the radiance of the light has been set. */
  update(light: DirectionalLightItem): void;
}

/**
 * Creates the shadow of a directional light from the params of `SUN_SHADOW`.
 *
 * @example
 * const shadow = createSunShadow(ctx);
 * // Every frame, after `light.radiance` has been set:
 * shadow.update(light);
 */
export function createSunShadow({ params, config, outputs }: SunShadowContext): SunShadow {
  const { castShadow, areaM, biasPx, sourceRad, contact } = params;
  const mapSizePx = Number(config.mapSize);
  const shadow: Writable<LightShadow> = { areaM: 0, mapSizePx, bias: 0, normalBiasM: 0, filter: config.filter, sourceRad: 0 };
  const contactShadow = createContactShadow(outputs.lights);
  return {
    update: (light) => {
      shadow.areaM = areaM.value;
      shadow.sourceRad = sourceRad.value;
      // Only the offset of receivers along their normal prevents shadow acne. It must match the width of the filter, so its unit is
      // pixels of the map.
      shadow.normalBiasM = (biasPx.value * areaM.value) / mapSizePx;
      light.shadow = castShadow.value ? shadow : null;
      contactShadow.update(castShadow.value ? contact.value : 0, areaM.value, light.radiance);
    },
  };
}
