import type { LightShadow } from './light-shadow.ts';
import type { DirectionalLightItem, LightList } from './scene-lists.ts';

/** The contact shadow of a light: the shadow of ambient light where objects touch, in addition to the light's own shadow. */
export interface ContactShadow {
  /**
   * Updates the contact shadow. Call it once per frame.
   *
   * @param strength Ambient light as a fraction of the light itself; 0 removes the contact shadow.
   * @param areaM Side of the square that the shadow map covers, meters; the same as that of the light's own shadow.
   * @param radiance Radiance of the light itself, linear-sRGB.
   */
  update(strength: number, areaM: number, radiance: Float32Array): void;
}

/** Size of the shadow map. A larger map would make no visible difference, because the shadow's edges are wide. */
const MAP_SIZE_PX = 512;
/** Angular diameter of the light that stands for the sky: 80°. With a wider one, the samples of the shadow filter are too far apart. */
const SOURCE_RAD = 1.4;
const BIAS_PX = 1;

/**
 * Adds a light for contact shadows to a list. A uniform sky is approximated by a wide light straight above: its contact-hardening
 * shadow is dark below an object and fades a little above the ground.
 *
 * @param lights The node's own light list; the light is in it while the strength is above 0.
 *
 * @example
 * const contact = createContactShadow(ctx.outputs.lights);
 * // Every frame:
 * contact.update(0.3, 5, light.radiance);
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
