import type { LampItem, LightItem } from '../../../../nodes/kit/runtime.ts';

/** Else it shines from all sides, and throws no shadow. */
export function isLamp(light: LightItem): light is LampItem {
  return light.kind !== 'environment' && light.kind !== 'probe';
}
