import type { DirectLightItem, LightItem } from '../../kit/scene-lists.ts';
import { MAX_GLOW_SPOTS, type ShadowGlow } from '../../kit/scene-look.ts';
import type { BoundingCylinder } from '../../kit/three/bounding-cylinders.ts';

/** Settings for the light that is drawn around objects. */
export interface GlowShape {
  /** How much larger the light is than the object and its shadow, as a fraction. */
  readonly margin: number;
  /** The greatest length of a shadow that the light extends along, meters. */
  readonly maxStretchM: number;
}

/**
 * The height above and below an object's base at which the light has faded, relative to the radius; so the floor below a table stays dark.
 */
const REACH = 0.6;
const MIN_REACH_M = 0.1;
/** Sine of the lowest elevation (3°) of lights that have a spot: shadows of lower lights are too long to be useful. */
const MIN_SINE = 0.05;

// Written and read within one call.
const scratchTowards = new Float32Array(3);

/** Whether a light casts its own shadow; false for the light that only casts the contact shadow of another. */
export function isShadowLight(light: LightItem): light is DirectLightItem {
  return light.kind !== 'environment' && light.kind !== 'probe' && !(light.kind === 'directional' && light.onlyShadows);
}

/**
 * Adds the spot of an object in a light: an ellipse on its base that contains the base and the shadow (ARPAS 2018, section 4.2). With the
 * radius r, the height h and the elevation e of the light, its semi-axes are r + h·cot(e)/2 and r, its center lies h·cot(e)/2 away
 * from the light, and both axes are larger by the margin. Beyond the maximum number of spots nothing is added.
 */
export function addSpot(
  glow: ShadowGlow,
  { baseWorld, radiusM, heightM }: BoundingCylinder,
  light: DirectLightItem,
  shape: GlowShape,
): void {
  if (glow.count >= MAX_GLOW_SPOTS || radiusM <= 0) return;
  towardsLight(light, baseWorld);
  const [x = 0, sine = 0, z = 0] = scratchTowards;
  if (sine < MIN_SINE) return;
  const horizontal = Math.hypot(x, z);
  const stretchM = Math.min((heightM * horizontal) / sine, shape.maxStretchM);
  const [alongX, alongZ] = horizontal > 1e-6 ? [-x / horizontal, -z / horizontal] : [1, 0];
  const at = glow.count++ * 4;
  glow.places[at] = (baseWorld[0] ?? 0) + (alongX * stretchM) / 2;
  glow.places[at + 1] = (baseWorld[2] ?? 0) + (alongZ * stretchM) / 2;
  glow.places[at + 2] = alongX;
  glow.places[at + 3] = alongZ;
  glow.sizes[at] = (radiusM + stretchM / 2) * (1 + shape.margin);
  glow.sizes[at + 1] = radiusM * (1 + shape.margin);
  glow.sizes[at + 2] = baseWorld[1] ?? 0;
  glow.sizes[at + 3] = Math.max(REACH * radiusM, MIN_REACH_M);
}

function towardsLight(light: DirectLightItem, fromWorld: Float32Array): void {
  if (light.kind === 'directional') {
    scratchTowards.set(light.towardsLightWorld);
    return;
  }
  let squared = 0;
  for (let i = 0; i < 3; i++) {
    const way = (light.positionWorld[i] ?? 0) - (fromWorld[i] ?? 0);
    scratchTowards[i] = way;
    squared += way * way;
  }
  const length = Math.sqrt(squared) || 1;
  for (let i = 0; i < 3; i++) scratchTowards[i] = (scratchTowards[i] ?? 0) / length;
}
