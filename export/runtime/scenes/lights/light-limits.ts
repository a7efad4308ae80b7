import type { WebGLRenderer } from 'three';
import type { LightItem, LightList } from '../../../../nodes/kit/scene-lists.ts';
import type { DrawBinding } from '../../scene-backend.ts';
import { isDirectLight } from './is-direct-light.ts';
import { MAX_VSM_PX, type MapLimits, mapSizeOf, needsFloats, shadowOf } from './light-map.ts';

/**
 * Maximum number of lights with shadows in one set of maps; the first ones count. WebGL 2 guarantees 16 texture units and 15 varyings;
 * three.js needs one of each per shadow, and ten textures for its largest material.
 */
export const MAX_SHADOWS = 6;

/**
 * Reports at the drawing node if the given lights exceed a limit: of shadows, of the size or filters of shadow maps, or of environments. It
 * is called every frame, because shadows can be switched at run time.
 */
export type LightLimits = (lists: readonly LightList[]) => void;

/** Creates the reports about lights that exceed limits. `shown` is `shadows` for a shadow layer, which draws no other light. */
export function createLightLimits(report: DrawBinding['report'], shown: 'all' | 'shadows', limits: MapLimits): LightLimits {
  return (lists) => {
    if (!report) return;
    const shadows = countLights(lists, (light) => shadowOf(light) !== null);
    if (shadows > MAX_SHADOWS) {
      report({
        code: 'SCR023',
        severity: 'warning',
        port: 'lights',
        message: `${shadows} lights cast shadows, but a scene supports ${MAX_SHADOWS}. The first ${MAX_SHADOWS} cast shadows, the others do not.`,
        fix: 'Turn “Cast shadows” off at the lights where it matters least.',
      });
    }
    if (countLights(lists, (light) => (shadowOf(light)?.mapSizePx ?? 0) > limits.maxSizePx) > 0) {
      report({
        code: 'SCR025',
        severity: 'info',
        port: 'lights',
        message: `This device limits shadow maps to ${limits.maxSizePx} pixels a side. Larger maps are reduced to that size.`,
        fix: 'Choose a smaller “Shadow resolution”, or a smaller “Shadow area”, so that all devices show the same.',
      });
    }
    if (countLights(lists, (light) => isCutForVariance(light, limits)) > 0) {
      report({
        code: 'SCR025',
        severity: 'info',
        port: 'lights',
        message: `Shadow maps with “Variance” edges are limited to ${MAX_VSM_PX} pixels a side, to save memory. Larger maps are reduced to that size.`,
        fix: `Choose ${MAX_VSM_PX} as the “Shadow resolution”, or other “Shadow edges”.`,
      });
    }
    if (shown === 'shadows' && !limits.floats && countLights(lists, (light) => needsFloats(shadowOf(light)?.filter)) > 0) {
      report({
        code: 'SCR025',
        severity: 'info',
        port: 'lights',
        message: 'This device cannot draw “Variance” or “Contact-hardening” shadow edges. These shadows use “Soft” instead.',
        fix: 'Choose “Soft” as the shadow edges, so that all devices show the same.',
      });
    }
    if (shown === 'shadows') return;
    const environments = countLights(lists, (light) => !isDirectLight(light));
    if (environments > 1) {
      report({
        code: 'SCR023',
        severity: 'warning',
        port: 'lights',
        message: `${environments} environment lights or light estimates are connected, and a scene uses one. The others have no effect.`,
        fix: 'Disconnect all of these lights but one.',
      });
    }
  };
}

function isCutForVariance(light: LightItem, limits: MapLimits): boolean {
  const shadow = shadowOf(light);
  return shadow !== null && mapSizeOf(shadow, limits) < Math.min(shadow.mapSizePx, limits.maxSizePx);
}

/** Reports at the drawing node that the device has too few texture units for all shadows. */
export interface TextureLimits {
  /** Reports how many lights use the filter `soft` instead of their own, and how many are not dimmed by transparent objects. */
  tell(softened: number, undimmed: number): void;
}

export function createTextureLimits(report: DrawBinding['report']): TextureLimits {
  return {
    tell: (softened, undimmed) => {
      if (!report || softened + undimmed === 0) return;
      const losses = [
        softened > 0 ? `${softened} of them use “Soft” shadow edges` : '',
        undimmed > 0 ? `transparent objects cast no shadow in the light of ${undimmed} of them` : '',
      ];
      report({
        code: 'SCR025',
        severity: 'warning',
        port: 'lights',
        message: `The shadows of these lights need more textures than the device has: ${losses.filter((loss) => loss !== '').join(', and ')}.`,
        fix: 'Turn “Cast shadows” off at the lights where it matters least, or choose “Soft” as their “Shadow edges”.',
      });
    },
  };
}

export function mapLimitsOf({ capabilities, extensions }: WebGLRenderer): MapLimits {
  const floats = extensions.has('EXT_color_buffer_float') && extensions.has('OES_texture_float_linear');
  return { maxSizePx: Math.min(capabilities.maxTextureSize, capabilities.maxCubemapSize), floats };
}

function countLights(lists: readonly LightList[], counts: (light: LightItem) => boolean): number {
  let count = 0;
  for (const { items } of lists) for (const light of items) if (counts(light)) count++;
  return count;
}
