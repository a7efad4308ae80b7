import type { LightShadow, LocalLightShadow, ShadowFilter } from '../../kit/light-shadow.ts';
import { createPointItem, createSpotItem } from '../../kit/local-lights.ts';
import type { FoundLamp } from '../../kit/panorama/found-lamps.ts';
import type { DirectionalLightItem, DirectLightItem } from '../../kit/scene-lists.ts';
import type { Writable } from '../../kit/value-views.ts';

/** The kinds of lights, in the order of the param. */
export type LampKind = 'directional' | 'spot' | 'point';

/** The values of a frame that apply to all lamps. */
export interface LampSetting {
  intensity: number;
  /** The rotation from panorama space to world space, about y. */
  rotationRad: number;
  distanceM: number;
  centerWorld: ArrayLike<number>;
  castShadow: boolean;
  /** Factor on the size of the lamps. */
  softness: number;
  areaM: number;
  biasPx: number;
}

/** The light of a lamp, in panorama space. The direction may change from frame to frame. */
export type LampLight = Pick<FoundLamp, 'irradiance' | 'sizeRad'> & { readonly towards: Direction };
type Direction = Readonly<[x: number, y: number, z: number]>;

/** A light of the output list that stands for a lamp. */
export interface LampItem {
  readonly item: DirectLightItem;
  update(setting: LampSetting): void;
}

/** The settings of the shadow map. */
export interface LampShadow {
  readonly mapSizePx: number;
  readonly filter: ShadowFilter;
}

/** Creates the light that stands for a lamp. */
export function createLampItem(key: string, kind: LampKind, lamp: LampLight, map: LampShadow): LampItem {
  switch (kind) {
    case 'directional':
      return directional(key, lamp, map);
    case 'spot':
      return spot(key, lamp, map);
    case 'point':
      return point(key, lamp, map);
  }
}

/** Creates a directional light; with `onlyShadows`, the light that casts only the shadow of the rest of the panorama. */
export function directional(
  key: string,
  { towards, irradiance, sizeRad }: LampLight,
  { mapSizePx, filter }: LampShadow,
  onlyShadows = false,
): LampItem & { readonly item: DirectionalLightItem } {
  const shadow: Writable<LightShadow> = { areaM: 0, mapSizePx, bias: 0, normalBiasM: 0, filter, sourceRad: 0 };
  const item: DirectionalLightItem = {
    key,
    kind: 'directional',
    ...(onlyShadows ? { onlyShadows } : {}),
    radiance: new Float32Array(3),
    towardsLightWorld: new Float32Array(3),
    shadow: null,
  };
  return {
    item,
    update: (setting) => {
      scale(item.radiance, irradiance, setting.intensity);
      turn(item.towardsLightWorld, towards, setting.rotationRad);
      shadow.areaM = setting.areaM;
      shadow.sourceRad = Math.min(sizeRad * setting.softness, MAX_SIZE_RAD);
      shadow.normalBiasM = (setting.biasPx * setting.areaM) / mapSizePx;
      item.shadow = setting.castShadow ? shadow : null;
    },
  };
}

/**
 * The greatest angular diameter of a lamp. With a wider one, the samples of the shadow filter are too far apart
 * (`nodes/kit/contact-shadow.ts`).
 */
export const MAX_SIZE_RAD = 1.4;

function spot(key: string, { towards, irradiance, sizeRad }: LampLight, { mapSizePx, filter }: LampShadow): LampItem {
  const shadow: LocalLightShadow = { mapSizePx, biasPx: 0, filter, sourceM: 0 };
  const item = createSpotItem(key);
  item.penumbra = PENUMBRA;
  return {
    item,
    update: (setting) => {
      const { distanceM } = setting;
      scale(item.intensityCd, irradiance, setting.intensity * distanceM * distanceM);
      turn(item.towardsLightWorld, towards, setting.rotationRad);
      place(item.positionWorld, item.towardsLightWorld, setting);
      // The cone covers the area of shadows around the center, which hangs above the floor.
      item.halfAngleRad = Math.min(Math.atan(setting.areaM / distanceM), MAX_HALF_ANGLE_RAD);
      shadow.biasPx = setting.biasPx;
      shadow.sourceM = sourceM(sizeRad, setting);
      item.shadow = setting.castShadow ? shadow : null;
    },
  };
}

const PENUMBRA = 0.2;
const MAX_HALF_ANGLE_RAD = 1.3;

function point(key: string, { towards, irradiance }: LampLight, { mapSizePx, filter }: LampShadow): LampItem {
  // Cube maps have the filters without their own textures only.
  const shadow: LocalLightShadow = { mapSizePx, biasPx: 0, filter: filter === 'basic' || filter === 'pcf' ? filter : 'soft' };
  const item = createPointItem(key);
  return {
    item,
    update: (setting) => {
      scale(item.intensityCd, irradiance, setting.intensity * setting.distanceM * setting.distanceM);
      turn(item.positionWorld, towards, setting.rotationRad);
      place(item.positionWorld, item.positionWorld, setting);
      shadow.biasPx = setting.biasPx;
      item.shadow = setting.castShadow ? shadow : null;
    },
  };
}

function sourceM(sizeRad: number, { distanceM, softness }: LampSetting): number {
  return 2 * distanceM * Math.tan(Math.min(sizeRad, MAX_SIZE_RAD) / 2) * softness;
}

function scale(into: Float32Array, irradiance: readonly [number, number, number], factor: number): void {
  for (let c = 0; c < 3; c++) into[c] = (irradiance[c] ?? 0) * factor;
}

/** Rotates a direction about y, counterclockwise seen from above, as `EnvironmentLightItem.rotationRad` does. */
export function turn(into: Float32Array, [x, y, z]: readonly [number, number, number], angleRad: number): void {
  const [cos, sin] = [Math.cos(angleRad), Math.sin(angleRad)];
  into[0] = x * cos + z * sin;
  into[1] = y;
  into[2] = z * cos - x * sin;
}

function place(into: Float32Array, towards: Float32Array, { centerWorld, distanceM }: LampSetting): void {
  for (let c = 0; c < 3; c++) into[c] = (centerWorld[c] ?? 0) + (towards[c] ?? 0) * distanceM;
}
