import type { Resource, ResourceId } from '../../program/program.ts';
import { isPass, type ScheduledOperation } from './scheduled.ts';
import { type Target, targetSizes } from './whole-size.ts';

/** The time in which a texture is needed: from the operation that draws it first to the last that reads it, as indices of the order. */
interface Lifetime {
  readonly target: Target;
  readonly first: number;
  last: number;
}

/**
 * Lets render targets with disjoint lifetimes share a texture: a chain of a hundred filters needs two. Only equal targets share, because
 * WebGL textures cannot be reinterpreted; each takes the texture that was released last, which is most likely to be in a cache. For a fixed
 * order and equal textures no assignment needs fewer; `order.ts` chooses the order. Linear time.
 *
 * Persistent and viewed targets do not share. All others are drawn completely in every frame: passes cover every pixel (the linker makes
 * `discard` transparent), and draws clear their target.
 */
export function shareTargets(
  operations: readonly ScheduledOperation[],
  resources: readonly Resource[],
  viewed: ReadonlySet<ResourceId>,
): Resource[] {
  const lifetimes = findLifetimes(operations, resources, viewed);
  const drawnAt = listBy(lifetimes, ({ first }) => first);
  const doneAt = listBy(lifetimes, ({ last }) => last);
  const textureOf = describeTextures(resources);
  const free = new Map<string, ResourceId[]>();
  const owners = new Map<ResourceId, ResourceId>();
  for (const place of operations.keys()) {
    for (const { target } of drawnAt.get(place) ?? []) owners.set(target.id, free.get(textureOf(target))?.pop() ?? target.id);
    // Released after the operation, because an operation cannot draw to a texture that it reads.
    for (const { target } of doneAt.get(place) ?? []) {
      const texture = textureOf(target);
      const list = free.get(texture);
      const owner = owners.get(target.id) ?? target.id;
      if (list) list.push(owner);
      else free.set(texture, [owner]);
    }
  }
  const depthRead = depthsRead(operations, owners);
  return resources.map((resource) => {
    if (resource.kind !== 'target') return resource;
    const owner = owners.get(resource.id) ?? resource.id;
    return { ...resource, ...(depthRead.has(resource.id) && { depthRead: true }), ...(owner !== resource.id && { shares: owner }) };
  });
}

/** Targets whose depth buffer a pass reads, or that have the texture of such a target. */
function depthsRead(operations: readonly ScheduledOperation[], owners: ReadonlyMap<ResourceId, ResourceId>): ReadonlySet<ResourceId> {
  const read = new Set<ResourceId>();
  for (const operation of operations) {
    for (const { source } of isPass(operation) ? operation.samplers : []) {
      if (source.kind !== 'depth' || source.depth.encoding !== 'window') continue;
      const { resource } = source.depth;
      read.add(owners.get(resource) ?? resource);
    }
  }
  return read;
}

function findLifetimes(
  operations: readonly ScheduledOperation[],
  resources: readonly Resource[],
  viewed: ReadonlySet<ResourceId>,
): Lifetime[] {
  const targets = new Map<ResourceId, Target>();
  for (const resource of resources) {
    if (resource.kind === 'target' && resource.lifetime === 'frame' && !viewed.has(resource.id)) targets.set(resource.id, resource);
  }
  const lifetimes = new Map<ResourceId, Lifetime>();
  for (const [place, operation] of operations.entries()) {
    for (const id of operation.reads) {
      const lifetime = lifetimes.get(id);
      // An operation that reads a target before it is drawn reads an earlier frame, so the target is not shared.
      if (!lifetime) targets.delete(id);
      // A target that is drawn once per frame is read for every view.
      else
        lifetime.last =
          operation.view === 'each' && lifetime.target.domain === 'image' ? Number.POSITIVE_INFINITY : Math.max(lifetime.last, place);
    }
    for (const id of operation.writes) {
      const target = targets.get(id);
      const lifetime = lifetimes.get(id);
      if (lifetime) lifetime.last = Math.max(lifetime.last, place);
      else if (target) lifetimes.set(id, { target, first: place, last: place });
    }
  }
  return [...lifetimes.values()].filter(({ target }) => targets.has(target.id));
}

/** Returns a text for each target that is equal for targets that can share a texture. */
function describeTextures(resources: readonly Resource[]): (target: Target) => string {
  const sizes = targetSizes(resources);
  return ({ id, domain, format, depth, samples }) => JSON.stringify([domain, sizes.get(id), format, depth, samples]);
}

function listBy(lifetimes: readonly Lifetime[], place: (lifetime: Lifetime) => number): ReadonlyMap<number, Lifetime[]> {
  const lists = new Map<number, Lifetime[]>();
  for (const lifetime of lifetimes) {
    const list = lists.get(place(lifetime));
    if (list) list.push(lifetime);
    else lists.set(place(lifetime), [lifetime]);
  }
  return lists;
}
