import { Vector3, Vector4 } from 'three';
import type { DirectLightItem } from '../../../../nodes/kit/scene-lists.ts';
import { MIN_PENUMBRA } from '../lights/light-rig.ts';

/** Direct lights in the form that `shadow-catcher-shader.ts` reads. */
export interface LightUniforms {
  readonly lightPlace: { readonly value: Vector4[] };
  readonly lightCone: { readonly value: Vector4[] };
  readonly lightFall: { readonly value: Vector3[] };
}

// Rec. 709 luminance of linear-sRGB.
const LUMINANCE = new Vector3(0.2126, 0.7152, 0.0722);

// Valid within one call.
const scratchColor = new Vector3();

const NO_CONE = -2;

export function createLightUniforms(): LightUniforms {
  return { lightPlace: { value: [] }, lightCone: { value: [] }, lightFall: { value: [] } };
}

/** Writes a light to index `i` of the uniforms. */
export function setLight({ lightPlace, lightCone, lightFall }: LightUniforms, i: number, light: DirectLightItem): void {
  lightPlace.value[i] ??= new Vector4();
  lightCone.value[i] ??= new Vector4();
  lightFall.value[i] ??= new Vector3();
  describe(light, lightPlace.value[i], lightCone.value[i], lightFall.value[i]);
}

export function setLightCount({ lightPlace, lightCone, lightFall }: LightUniforms, count: number): void {
  for (const { value } of [lightPlace, lightCone, lightFall]) value.length = count;
}

function describe(light: DirectLightItem, place: Vector4, cone: Vector4, fall: Vector3): void {
  cone.set(0, 0, 0, NO_CONE);
  if (light.kind === 'directional') {
    const [x = 0, y = 0, z = 0] = light.towardsLightWorld;
    place.set(x, y, z, 0);
    fall.set(luminanceOf(light.radiance), 0, 0);
    return;
  }
  const [x = 0, y = 0, z = 0] = light.positionWorld;
  place.set(x, y, z, 1);
  fall.set(luminanceOf(light.intensityCd), light.rangeM, 0);
  if (light.kind !== 'spot') return;
  const [towardsX = 0, towardsY = 0, towardsZ = 0] = light.towardsLightWorld;
  cone.set(towardsX, towardsY, towardsZ, Math.cos(light.halfAngleRad));
  fall.z = Math.cos(light.halfAngleRad * (1 - Math.max(light.penumbra, MIN_PENUMBRA)));
}

function luminanceOf(color: Float32Array): number {
  return scratchColor.fromArray(color).dot(LUMINANCE);
}
