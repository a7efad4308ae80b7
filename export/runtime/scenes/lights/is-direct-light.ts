import type { DirectLightItem, LightItem } from '../../../../nodes/kit/scene-lists.ts';

/** Whether a light has a position or direction. Other lights come from everywhere and cast no shadow. */
export function isDirectLight(light: LightItem): light is DirectLightItem {
  switch (light.kind) {
    case 'directional':
    case 'point':
    case 'spot':
      return true;
    case 'environment':
    case 'probe':
      return false;
  }
}
