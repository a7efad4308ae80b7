import type { Resource, ResourceId, SizeExpression, TargetSize } from '../../program/program.ts';
import type { ScheduledOperation } from './scheduled.ts';

type Target = Extract<Resource, { kind: 'target' }>;

/** When a picture is there: from the operation that draws it first to the last that reads it, as places in the order. */
interface Lifetime {
  readonly target: Target;
  readonly first: number;
  last: number;
}

/**
 * Lets pictures that are never there at the same time be drawn into the same texture: a chain of a hundred filters needs two, not a
 * hundred. Only equal ones share, because WebGL textures cannot be seen as others; each takes the one that was let go last, which
 * is the likeliest to be in a cache still. The order has been chosen so that few are there at a time (`order.ts`); for a fixed
 * order and equal textures, no assignment needs fewer than this one. Linear.
 *
 * A picture that lasts, or that is looked at, keeps a texture to itself. All others are drawn whole in every frame: passes cover
 * every pixel (the linker makes `discard` transparent), and objects are drawn into a cleared target.
 */
export function shareTargets(
  operations: readonly ScheduledOperation[],
  resources: readonly Resource[],
  looked: ReadonlySet<ResourceId>,
): Resource[] {
  const lifetimes = findLifetimes(operations, resources, looked);
  const drawnAt = listBy(lifetimes, ({ first }) => first);
  const doneAt = listBy(lifetimes, ({ last }) => last);
  const textureOf = describeTextures(resources);
  const free = new Map<string, ResourceId[]>();
  const owners = new Map<ResourceId, ResourceId>();
  for (const place of operations.keys()) {
    for (const { target } of drawnAt.get(place) ?? []) owners.set(target.id, free.get(textureOf(target))?.pop() ?? target.id);
    // Only now, because an operation cannot draw into what it reads.
    for (const { target } of doneAt.get(place) ?? []) {
      const texture = textureOf(target);
      const list = free.get(texture);
      const owner = owners.get(target.id) ?? target.id;
      if (list) list.push(owner);
      else free.set(texture, [owner]);
    }
  }
  return resources.map((resource) => {
    const owner = owners.get(resource.id);
    return resource.kind !== 'target' || owner === undefined || owner === resource.id ? resource : { ...resource, shares: owner };
  });
}

function findLifetimes(
  operations: readonly ScheduledOperation[],
  resources: readonly Resource[],
  looked: ReadonlySet<ResourceId>,
): Lifetime[] {
  const targets = new Map<ResourceId, Target>();
  for (const resource of resources) {
    if (resource.kind === 'target' && resource.lifetime === 'frame' && !looked.has(resource.id)) targets.set(resource.id, resource);
  }
  const lifetimes = new Map<ResourceId, Lifetime>();
  for (const [place, operation] of operations.entries()) {
    for (const id of operation.reads) {
      const lifetime = lifetimes.get(id);
      // An operation that reads a target before it is drawn reads an earlier frame, so the target is not shared.
      if (!lifetime) targets.delete(id);
      // What is drawn once is read for every view.
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

/**
 * Tells targets apart that no single texture could serve: equal answers, equal textures. A size that is that of another picture is
 * followed to where it comes from, so that a chain of pictures of a file's size is one kind.
 */
function describeTextures(resources: readonly Resource[]): (target: Target) => string {
  const sizes = new Map<ResourceId, TargetSize>();
  for (const resource of resources) {
    if (resource.kind !== 'target') continue;
    const { base, width, height } = resource.size;
    // Whatever a size is relative to has been scheduled before.
    sizes.set(resource.id, (isWhole(width, 'width') && isWhole(height, 'height') && sizes.get(base)) || resource.size);
  }
  return ({ id, domain, format, depth, samples }) => JSON.stringify([domain, sizes.get(id), format, depth, samples]);
}

function isWhole(expression: SizeExpression, side: 'width' | 'height'): boolean {
  const [token] = expression;
  return expression.length === 1 && typeof token === 'object' && 'op' in token && token.op === side;
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
