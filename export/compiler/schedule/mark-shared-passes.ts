import type { LayerRef, Resource, ResourceId } from '../../program/program.ts';
import { passReadsView } from '../../program/reads-view.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from './scheduled.ts';

/** The program as far as it matters here. `resources` are those that share textures. */
interface Drawn {
  readonly operations: readonly ScheduledOperation[];
  readonly resources: readonly Resource[];
  readonly taps: Readonly<Record<string, LayerRef>>;
}

/**
 * Marks the passes of each view that need not be drawn again for a second view of equal size: they read nothing of the room, the camera or
 * objects, only images of their own size, values and other such passes.
 *
 * Views of equal size share the targets. What such passes leave for others must therefore be the last that is drawn to its texture, and all
 * that is drawn there before must be left out for the second view too.
 */
export function markSharedPasses(drawn: Drawn): ScheduledOperation[] {
  const { operations, resources } = drawn;
  const textures = new Map(
    resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource.shares ?? resource.id]] : [])),
  );
  const readers = operationsBy(operations, ({ reads }) => reads);
  const writers = operationsBy(operations, ({ writes }) => writes.flatMap((id) => textures.get(id) ?? []));
  const shared = new Set<ScheduledOperation>(sameForAllViews(drawn));
  const isLeft = ({ target }: ScheduledPass) => readers.get(target)?.some((reader) => !shared.has(reader)) ?? true;
  const isKept = (pass: ScheduledPass) => {
    const drawnThere = writers.get(textures.get(pass.target) ?? '') ?? [];
    return drawnThere.at(-1) === pass && drawnThere.every((writer) => shared.has(writer));
  };
  // A pass that is drawn for each view reads what other passes leave.
  for (let before = -1; before !== shared.size; ) {
    before = shared.size;
    for (const pass of [...shared].reverse()) if (isPass(pass) && isLeft(pass) && !isKept(pass)) shared.delete(pass);
  }
  return operations.map((operation) => (isPass(operation) && shared.has(operation) ? { ...operation, sameForViews: true } : operation));
}

/** The passes that draw the same image for all views of one size. */
function sameForAllViews({ operations, resources, taps }: Drawn): ScheduledPass[] {
  const byId = new Map(resources.map((resource) => [resource.id, resource]));
  const viewed = new Set(Object.values(taps).flatMap(({ color, depth }) => [color, depth?.resource ?? color]));
  const drawn = new Set<ResourceId>();
  const isSame = (id: ResourceId) => drawn.has(id) || isImage(byId.get(id));
  return operations.filter((operation): operation is ScheduledPass => {
    if (!isPass(operation) || operation.view !== 'each' || !readsOnly(operation, isSame) || passReadsView(operation)) return false;
    const target = byId.get(operation.target);
    // Kept and viewed layers have a texture for each view.
    if (target?.kind !== 'target' || target.lifetime !== 'frame' || viewed.has(target.id)) return false;
    drawn.add(target.id);
    return true;
  });
}

function readsOnly({ samplers }: ScheduledPass, isSame: (id: ResourceId) => boolean): boolean {
  return samplers.every(({ source }) => {
    if (source.kind === 'color') return isSame(source.resource);
    return source.kind === 'table' || source.kind === 'import' || source.kind === 'sound';
  });
}

function isImage(resource: Resource | undefined): boolean {
  return (resource?.kind === 'target' || resource?.kind === 'external') && resource.domain === 'image';
}

function operationsBy(
  operations: readonly ScheduledOperation[],
  list: (operation: ScheduledOperation) => readonly ResourceId[],
): ReadonlyMap<ResourceId, readonly ScheduledOperation[]> {
  const found = new Map<ResourceId, ScheduledOperation[]>();
  for (const operation of operations) {
    for (const id of new Set(list(operation))) {
      const known = found.get(id);
      if (known) known.push(operation);
      else found.set(id, [operation]);
    }
  }
  return found;
}
