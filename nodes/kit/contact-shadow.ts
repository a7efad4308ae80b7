import type { LightShadow } from './light-shadow.ts';
import type { DirectionalLightItem, LightList } from './scene-lists.ts';

/** The shadow that light from all sides leaves where things touch, besides that of the light itself. */
export interface ContactShadow {
  /**
   * Once per frame. `strength`: how much light comes from all sides, as a part of the light itself; at 0 there is no such shadow.
   * `areaM`: as of the light's own shadow.
   */
  update(strength: number, areaM: number, radiance: Float32Array): void;
}

/** Its edges are wide and are seen near by alone; finer would be wasted. */
const MAP_SIZE_PX = 512;
/** What a surface sees of the sky that matters: 80°. Wider, and taps of the filter lie too far apart. */
const SOURCE_RAD = 1.4;
const BIAS_PX = 1;

/**
 * Adds a light for contact shadows to a list. A uniform sky is approximated by a wide light straight above: its contact-hardening
 * shadow is dark below an object and fades a little above the ground.
 *
 * @param lights The node's own light list.
 *
 * @example
 * const contact = createContactShadow(ctx.outputs.lights);
 */
export function createContactShadow(lights: LightList): ContactShadow {
  const shadow: LightShadow = { areaM: 0, mapSizePx: MAP_SIZE_PX, bias: 0, normalBiasM: 0, filter: 'pcss', sourceRad: SOURCE_RAD };
  const light: DirectionalLightItem = {
    key: 'contact',
    kind: 'directional',
    onlyShadows: true,
    radiance: new Float32Array(3),
    towardsLightWorld: Float32Array.of(0, 1, 0),
    shadow,
  };
  let listed = false;
  return {
    update: (strength, areaM, radiance) => {
      shadow.areaM = areaM;
      shadow.normalBiasM = (BIAS_PX * areaM) / MAP_SIZE_PX;
      for (let c = 0; c < 3; c++) light.radiance[c] = (radiance[c] ?? 0) * strength;
      if (strength > 0 === listed) return;
      listed = !listed;
      if (listed) lights.items.push(light);
      else lights.items.splice(lights.items.indexOf(light), 1);
      lights.version++;
    },
  };
}
