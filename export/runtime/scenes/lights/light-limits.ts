import type { LightItem, LightList } from '../../../../nodes/kit/runtime.ts';
import type { DrawBinding } from '../../scene-backend.ts';
import { isLamp } from './is-lamp.ts';
import { shadowOf } from './light-map.ts';
import { MAX_SHADOWS } from './shadow-maps.ts';

/** Tells the node that draws when it is wired more lights than can be drawn; every frame, because shadows are switched while running. */
export type LightLimits = (lists: readonly LightList[]) => void;

/** `shadows`: of a layer that shows nothing else. */
export function createLightLimits(report: DrawBinding['report'], shown: 'all' | 'shadows'): LightLimits {
  return (lists) => {
    if (!report) return;
    const shadows = countLights(lists, (light) => shadowOf(light) !== null);
    if (shadows > MAX_SHADOWS) {
      report({
        code: 'SCR023',
        severity: 'warning',
        port: 'lights',
        message: `${shadows} lights cast shadows here, and ${MAX_SHADOWS} can: the first ${MAX_SHADOWS} do, the others shine through things.`,
        fix: 'Turn “Cast shadows” off at the lights where it matters least.',
      });
    }
    if (shown === 'shadows') return;
    const surroundings = countLights(lists, (light) => !isLamp(light));
    if (surroundings > 1) {
      report({
        code: 'SCR023',
        severity: 'warning',
        port: 'lights',
        message: `${surroundings} lights from all sides are wired here, Environment lights or Light estimates, and a scene has one: the first lights it, the others do not.`,
        fix: 'Remove all wires of such lights but one.',
      });
    }
  };
}

function countLights(lists: readonly LightList[], counts: (light: LightItem) => boolean): number {
  let count = 0;
  for (const { items } of lists) for (const light of items) if (counts(light)) count++;
  return count;
}
