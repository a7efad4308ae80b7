import type { Resource, ResourceId } from '../../../program/program.ts';
import { isWhole, type Target } from '../whole-size.ts';

/** Drops targets. Sizes that are relative to a dropped one become relative to what its size is relative to. */
export function withoutTargets(resources: readonly Resource[], dropped: ReadonlySet<ResourceId>): Resource[] {
  const targets = new Map(resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource] as const] : [])));
  return resources.flatMap((resource): Resource[] => {
    if (dropped.has(resource.id)) return [];
    return resource.kind === 'target' ? [rebased(resource, targets, dropped)] : [resource];
  });
}

function rebased(target: Target, targets: ReadonlyMap<ResourceId, Target>, dropped: ReadonlySet<ResourceId>): Target {
  let { size } = target;
  for (let base = targets.get(size.base); base !== undefined && dropped.has(base.id); base = targets.get(size.base)) {
    size = isWhole(size) ? base.size : { ...size, base: base.size.base };
  }
  return size === target.size ? target : { ...target, size };
}
