import type { PassSampler, Resource, ResourceId } from '../../../program/program.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from '../scheduled.ts';
import { type FoundGroups, type FuseInput, findGroups } from './find-groups.ts';
import { isRecomputed } from './recompute-cost.ts';
import type { SeparateReason, SeparateWire } from './separate-wire.ts';

/** Operations with copies of passes, of which each group of readers has its own. */
export interface Recomputed extends FoundGroups {
  readonly operations: readonly ScheduledOperation[];
  readonly resources: readonly Resource[];
}

type Input = Omit<FuseInput, 'repeated'>;

/** Bounds for the time of the compiler: layers behind layers that are computed again, and attempts without those that cannot be. */
const MAX_ROUNDS = 4;
const MAX_ATTEMPTS = 4;

/** What stands between the id of an operation or a resource and the number of its copy; ids of nodes do not contain it. */
const COPY = '~';

/**
 * Finds the passes that become one, and copies passes whose layer several groups read if it costs less to compute it in each of them
 * (`isRecomputed`). A layer is stored if one of its readers cannot compute it.
 */
export function findGroupsWithCopies(input: Input): Recomputed {
  const stored = new Set<ResourceId>();
  for (let attempt = 0; attempt < MAX_ATTEMPTS; attempt++) {
    const copied = copyWhereCheap(input, stored);
    const left = copied.separate.flatMap(({ resource }) => (copied.repeated.has(resource) ? [originalId(resource)] : []));
    if (left.length === 0) return labeled(copied, 'readers');
    for (const resource of left) stored.add(resource);
  }
  return labeled({ ...input, ...findGroups({ ...input, repeated: new Set() }) }, 'readers');
}

/** Finds the passes that become one, each computed once. Layers that could be computed again for their readers need too much memory. */
export function findGroupsWithoutCopies(input: Input): Recomputed {
  return labeled({ ...input, ...findGroups({ ...input, repeated: new Set() }) }, 'memory');
}

interface Copied extends Recomputed {
  /** Layers, and copies of layers, that are computed for each of their readers. */
  readonly repeated: ReadonlySet<ResourceId>;
}

function copyWhereCheap(input: Input, stored: ReadonlySet<ResourceId>): Copied {
  const repeated = new Set<ResourceId>();
  let { operations, resources } = input;
  let found = findGroups({ ...input, repeated });
  for (let round = 0; round < MAX_ROUNDS; round++) {
    const chosen = candidates(operations, resources, found).filter(
      ({ layer, isCheap }) => isCheap && !stored.has(originalId(layer.id)) && !repeated.has(layer.id),
    );
    if (chosen.length === 0) break;
    for (const candidate of chosen) {
      const copies = copyPasses(operations, resources, candidate);
      ({ operations, resources } = copies);
      for (const id of copies.layers) repeated.add(id);
    }
    found = findGroups({ ...input, operations, resources, repeated });
  }
  return { ...found, operations, resources, repeated };
}

type Layer = Extract<Resource, { kind: 'target' }>;

/** A layer that several groups, or one for several pixels, read as a texture, though each could compute it. */
interface Candidate {
  readonly layer: Layer;
  /** Ids of the passes that compute it. */
  readonly passes: ReadonlySet<string>;
  /** Ids of the passes that read it, by group. */
  readonly readers: readonly ReadonlySet<string>[];
  readonly isCheap: boolean;
}

function candidates(operations: readonly ScheduledOperation[], resources: readonly Resource[], found: FoundGroups): Candidate[] {
  const places = new Map(operations.map(({ id }, place) => [id, place]));
  const readersOf = new Map<ResourceId, number>();
  for (const { reads } of operations) for (const id of new Set(reads)) readersOf.set(id, (readersOf.get(id) ?? 0) + 1);
  const wires = new Map<ResourceId, SeparateWire[]>();
  for (const wire of found.separate) wires.set(wire.resource, [...(wires.get(wire.resource) ?? []), wire]);
  const targets = new Map(resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource] as const] : [])));

  return [...wires].flatMap(([id, into]): Candidate[] => {
    const layer = targets.get(id);
    const readers = new Set(into.map(({ reader }) => reader));
    const [writer] = into.flatMap((wire) => places.get(wire.writer) ?? []);
    const isAll = readersOf.get(id) === readers.size && into.every(({ reason }) => reason === 'readers' || reason === 'cost');
    if (layer === undefined || writer === undefined || !isAll) return [];
    const members = [...(found.groupOf.get(writer)?.keys() ?? [])].flatMap((place) => passesAt(operations, place));
    if (members.some(({ target }) => targets.get(target)?.lifetime !== 'frame')) return [];
    const groups = new Map<unknown, Set<string>>();
    for (const reader of readers) {
      const place = places.get(reader) ?? -1;
      const group = found.groupOf.get(place) ?? place;
      groups.set(group, (groups.get(group) ?? new Set()).add(reader));
    }
    const pixels = [...groups.values()].map((group) =>
      [...group].reduce((sum, reader) => sum + pixelsRead(passesAt(operations, places.get(reader) ?? -1), id), 0),
    );
    // Of several readers at the current pixel in one group, each reads the same.
    const evaluations = pixels.map((count) => Math.max(1, count));
    return [
      {
        layer,
        passes: new Set(members.map((member) => member.id)),
        readers: [...groups.values()],
        isCheap: isRecomputed({ passes: members, format: layer.format, readers: evaluations }),
      },
    ];
  });
}

function passesAt(operations: readonly ScheduledOperation[], place: number): readonly ScheduledPass[] {
  const operation = operations[place];
  return operation !== undefined && isPass(operation) ? [operation] : [];
}

/** The number of pixels of a layer that a pass computes if it does not read them: none if it reads only the current one. */
function pixelsRead([pass]: readonly ScheduledPass[], layer: ResourceId): number {
  if (pass === undefined || typeof pass.parts === 'string') return 0;
  const names = new Set(pass.samplers.flatMap(({ name, source }) => (source.kind === 'color' && source.resource === layer ? [name] : [])));
  return pass.parts.images.reduce(
    (sum, { image, isHere, reads }) => (names.has(image.sampler) && !isHere ? sum + reads.here + reads.texels : sum),
    0,
  );
}

interface Copies {
  readonly operations: readonly ScheduledOperation[];
  readonly resources: readonly Resource[];
  /** The layer and its copies. */
  readonly layers: readonly ResourceId[];
}

/** Gives each group of readers, except for the first one, copies of the passes that compute a layer. */
function copyPasses(operations: readonly ScheduledOperation[], resources: readonly Resource[], candidate: Candidate): Copies {
  const { layer, passes, readers } = candidate;
  const own = new Set(operations.flatMap((operation) => (passes.has(operation.id) && isPass(operation) ? [operation.target] : [])));
  const copyNumbers = readers.slice(1).map((_, i) => i + 1);
  const copyOf = (id: ResourceId, copy: number) => `${id}${COPY}${copy}`;
  const groupOf = new Map(readers.flatMap((group, i) => [...group].map((reader) => [reader, i] as const)));
  return {
    operations: operations.flatMap((operation): ScheduledOperation[] => {
      const copy = groupOf.get(operation.id) ?? 0;
      if (copy > 0 && isPass(operation)) return [renamed(operation, (id) => (id === layer.id ? copyOf(id, copy) : id))];
      if (!passes.has(operation.id) || !isPass(operation)) return [operation];
      const copies = copyNumbers.map((number) => ({
        ...renamed(operation, (id) => (own.has(id) ? copyOf(id, number) : id)),
        id: copyOf(operation.id, number),
      }));
      return [operation, ...copies];
    }),
    resources: resources.flatMap((resource) =>
      own.has(resource.id) ? [resource, ...copyNumbers.map((number) => ({ ...resource, id: copyOf(resource.id, number) }))] : [resource],
    ),
    layers: [layer.id, ...copyNumbers.map((number) => copyOf(layer.id, number))],
  };
}

function renamed(pass: ScheduledPass, nameOf: (id: ResourceId) => ResourceId): ScheduledPass {
  const samplers = pass.samplers.map((sampler): PassSampler => {
    const { source } = sampler;
    return source.kind === 'color' ? { ...sampler, source: { ...source, resource: nameOf(source.resource) } } : sampler;
  });
  return { ...pass, samplers, reads: pass.reads.map(nameOf), writes: pass.writes.map(nameOf), target: nameOf(pass.target) };
}

/** The id of an operation or a resource of which a copy has another. */
export function originalId(id: string): string {
  return id.replace(/~.*$/, '');
}

/**
 * The result with the reasons of layers that several passes read: whether it costs too much to compute them, or one needs the texture.
 *
 * @param cheap The reason where it costs little.
 */
function labeled(copied: Recomputed, cheap: SeparateReason): Recomputed {
  const { operations, resources, separate } = copied;
  const found = candidates(operations, resources, copied);
  const reasons = new Map(found.map(({ layer, isCheap }): [ResourceId, SeparateReason] => [layer.id, isCheap ? cheap : 'cost']));
  const wires = separate.map((wire): SeparateWire => {
    const { resource, reason } = wire;
    const named = { ...wire, resource: originalId(resource), writer: originalId(wire.writer), reader: originalId(wire.reader) };
    return reason === 'readers' || reason === 'cost' ? { ...named, reason: reasons.get(resource) ?? 'readers' } : named;
  });
  const unique = new Map(wires.map((wire) => [JSON.stringify(wire), wire]));
  return { ...copied, separate: [...unique.values()] };
}
