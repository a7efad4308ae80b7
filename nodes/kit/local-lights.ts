import type { PointLightItem, SpotLightItem } from './scene-lists.ts';
import type { Writable } from './value-views.ts';

/**
 * Creates a spot light at the origin that is dark; its node sets it in each frame.
 *
 * @example
 * const light = createSpotItem('light');
 * ctx.outputs.lights.items.push(light);
 */
export function createSpotItem(key: string): Writable<SpotLightItem> {
  return {
    key,
    kind: 'spot',
    intensityCd: new Float32Array(3),
    positionWorld: new Float32Array(3),
    towardsLightWorld: new Float32Array(3),
    rangeM: 0,
    halfAngleRad: 0,
    penumbra: 0,
    shadow: null,
  };
}

/**
 * Creates the item of a point light, dark and at the origin.
 *
 * @example
 * const item = createPointItem('lamp-1');
 * item.intensityCd.set([60, 55, 50]);
 */
export function createPointItem(key: string): Writable<PointLightItem> {
  return { key, kind: 'point', intensityCd: new Float32Array(3), positionWorld: new Float32Array(3), rangeM: 0, shadow: null };
}
