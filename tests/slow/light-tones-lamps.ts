import { Vector3 } from 'three';
import type { LoadedEnvironment } from '../../export/runtime/scene-backend.ts';
import type { DirectLightItem, LightItem } from '../../nodes/kit/scene-lists.ts';
import { bulb, spot, sun } from '../browser/scenes-kit.ts';

/** The light of one scene at any brightness. */
export interface Lamps {
  /** Brightness of the neutral environment, where `around` is null. */
  readonly ambient: number;
  readonly direct: DirectLightItem | null;
  around(factor: number): LightItem | null;
}

export const LAMP_NAMES = ['default', 'sun', 'back', 'bulb', 'spot', 'neutral', 'panorama', 'interior', 'estimate'] as const;
export type LampName = (typeof LAMP_NAMES)[number];
export const PANORAMAS = { panorama: 'royal_esplanade_1k.hdr', interior: 'blender_interior.exr' } as const;

const SHADOW = { areaM: 4, mapSizePx: 1024, bias: 0, normalBiasM: 0.02 };

/** A room that is bright from above and, in warm light, from the right: coefficients of Ramamoorthi and Hanrahan 2001. */
const ESTIMATE = Float32Array.of(
  ...[1.9, 1.8, 1.7],
  ...[0.6, 0.6, 0.6],
  ...[0.1, 0.1, 0.1],
  ...[0.4, 0.3, 0.2],
  ...[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
);

export function lampsOf(name: LampName, panoramas: ReadonlyMap<string, LoadedEnvironment>): Lamps {
  const only = (direct: DirectLightItem | null, ambient = 0): Lamps => ({ ambient, direct, around: () => null });
  switch (name) {
    case 'default':
      return only(sun([0.5, 0.8, 0.7], { radiance: 0.8 * Math.PI }), 0.5);
    case 'sun':
      return only(sun([1, 0.7, 0.4], { radiance: 0.9 * Math.PI, shadow: SHADOW }));
    case 'back':
      return only(sun([-0.4, 0.5, -1], { radiance: Math.PI }), 0.2);
    case 'bulb':
      return only(bulb([1.5, 2, 2], 24));
    case 'spot':
      return only(spot([-3, 3, 3], [0, 0, 0], 70));
    case 'neutral':
      return only(null, 0.9);
    case 'panorama':
    case 'interior': {
      const environment = panoramas.get(PANORAMAS[name]) ?? null;
      // Exposed so that white is about white.
      const intensity = name === 'panorama' ? 0.7 : 1;
      return {
        ambient: 0,
        direct: null,
        around: (factor) => ({
          key: 'sky',
          kind: 'environment',
          environment,
          intensity: intensity * factor,
          rotationRad: 1,
          visible: false,
        }),
      };
    }
    case 'estimate':
      return {
        ambient: 0,
        direct: sun([0.7, 0.9, 0.3], { radiance: 0.5 * Math.PI }),
        around: (factor) => ({ key: 'probe', kind: 'probe', sphericalHarmonics: ESTIMATE, reflection: null, intensity: factor }),
      };
  }
}

/** A light of another brightness. */
export function dimmed(light: DirectLightItem, factor: number): DirectLightItem {
  const scaled = (numbers: Float32Array): Float32Array => numbers.map((value) => value * factor);
  return light.kind === 'directional'
    ? { ...light, radiance: scaled(light.radiance) }
    : { ...light, intensityCd: scaled(light.intensityCd) };
}

/** Direction to a white light from a point, and the luminance of a white matte surface there that faces it. */
export function reaching(light: DirectLightItem, at: Vector3): { towards: Vector3; onWhite: number } {
  if (light.kind === 'directional') {
    return { towards: new Vector3(...light.towardsLightWorld), onWhite: (light.radiance[0] ?? 0) / Math.PI };
  }
  const towards = new Vector3(...light.positionWorld).sub(at);
  const onWhite = (light.intensityCd[0] ?? 0) / towards.lengthSq() / Math.PI;
  return { towards: towards.normalize(), onWhite };
}
