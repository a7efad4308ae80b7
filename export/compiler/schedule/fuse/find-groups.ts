import type { PassParts } from '../../../glsl/link/link-parts.ts';
import type { PassSampler, Resource, ResourceId, TargetSize } from '../../../program/program.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from '../scheduled.ts';
import { isWhole, type Target, targetSizes, VIEW_SIZE } from '../whole-size.ts';
import type { SeparateReason, SeparateWire } from './separate-wire.ts';

/** Passes that become one: indices of operations, ascending. The last one gives the target. */
export type PassGroup = readonly number[];

export interface FoundGroups {
  readonly groups: readonly PassGroup[];
  /** Wires into passes that stay as they are. */
  readonly separate: readonly SeparateWire[];
}

export interface FuseInput {
  readonly operations: readonly ScheduledOperation[];
  readonly resources: readonly Resource[];
  /** Targets that something outside of the program shows. */
  readonly viewed: ReadonlySet<ResourceId>;
  /** Nodes whose passes keep shaders of their own. */
  readonly unfused: ReadonlySet<string>;
  /** Number of drawn layers up to which a pass may join a shader that thereby reads more of them; with -1 no pass joins. */
  readonly maxLayers: number;
}

/** Samplers that every WebGL 2 device has in a fragment shader (OpenGL ES 3.0.6, table 6.33). */
const MAX_SAMPLERS = 16;

/** Of the 224 vectors of uniforms that every device has (same table); the rest is for the driver. */
const MAX_UNIFORM_VECTORS = 192;

/** Vectors of one sampler: its matrix, its size, how its depth is decoded, and how room depth is read. */
const SAMPLER_VECTORS = 6;

/** A bound for the time in which drivers compile a shader. */
const MAX_PASSES = 32;

/** A layer that a pass samples, with the indices of its writer and its reader. */
interface Wire {
  readonly writer: number;
  readonly reader: number;
  readonly resource: ResourceId;
  readonly sampler: PassSampler;
}

/**
 * Finds the passes that can be drawn by one shader. Each group grows from its last pass towards the sources: a pass joins if only passes of
 * the group read its layer, each at the current pixel. So no pixel is computed twice, and diamonds become one pass. Time is linear in the
 * number of operations, because the size of groups is limited.
 */
export function findGroups(input: FuseInput): FoundGroups {
  const { operations } = input;
  const rules = createRules(input);
  const groupOf = new Map<number, ReadonlySet<number>>();
  for (let root = operations.length - 1; root >= 0; root -= 1) {
    const operation = operations[root];
    if (operation === undefined || !isPass(operation) || groupOf.has(root)) continue;
    const group = grow(root, rules);
    for (const member of group) groupOf.set(member, group);
  }
  const separate = operations.flatMap((operation, reader) =>
    rules.wiresInto(reader).flatMap((wire): SeparateWire[] => {
      const group = groupOf.get(reader) ?? new Set([reader]);
      const reason = group.has(wire.writer) ? null : rules.whySeparate(wire, group);
      const writer = operations[wire.writer];
      return reason === null || writer === undefined ? [] : [{ resource: wire.resource, writer: writer.id, reader: operation.id, reason }];
    }),
  );
  const groups = [...new Set(groupOf.values())].filter((group) => group.size > 1);
  return { groups: groups.map((group) => [...group].sort((a, b) => a - b)), separate };
}

function grow(root: number, { wiresInto, whySeparate }: Rules): ReadonlySet<number> {
  const group = new Set([root]);
  let open = [...wiresInto(root)];
  for (let grows = true; grows; ) {
    grows = false;
    const left: Wire[] = [];
    for (const wire of open) {
      if (group.has(wire.writer)) continue;
      if (whySeparate(wire, group) === null) {
        group.add(wire.writer);
        left.push(...wiresInto(wire.writer));
        grows = true;
      } else {
        left.push(wire);
      }
    }
    open = left;
  }
  return group;
}

interface Rules {
  /** The layers that an operation samples and another operation writes; none if it is no pass. */
  wiresInto(reader: number): readonly Wire[];
  /** Why the writer of a wire cannot join the group of its reader; null if it can. */
  whySeparate(wire: Wire, group: ReadonlySet<number>): SeparateReason | null;
}

function createRules({ operations, resources, viewed, unfused, maxLayers }: FuseInput): Rules {
  const writers = placesBy(operations, ({ writes }) => writes);
  const readers = placesBy(operations, ({ reads }) => reads);
  const targets = new Map(resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource] as const] : [])));
  const sizes = targetSizes(resources);
  const fixedBases = basesOfParts(targets.values());

  const passAt = (place: number): ScheduledPass | null => {
    const operation = operations[place];
    return operation !== undefined && isPass(operation) ? operation : null;
  };
  const sizeOf = ({ target }: ScheduledPass): TargetSize | undefined => (target === 'screen' ? VIEW_SIZE : sizes.get(target));

  function wiresInto(reader: number): Wire[] {
    return (passAt(reader)?.samplers ?? []).flatMap((sampler): Wire[] => {
      if (sampler.source.kind !== 'color') return [];
      const { resource } = sampler.source;
      const [writer] = writers.get(resource) ?? [];
      return writer === undefined || !targets.has(resource) ? [] : [{ writer, reader, resource, sampler }];
    });
  }

  /** Number of drawn layers that the shader of these passes reads. They all exist while it draws. */
  function layersRead(passes: readonly ScheduledPass[]): number {
    const written = new Set(passes.map(({ target }) => target));
    const read = new Set(passes.flatMap(({ reads }) => reads));
    return [...read].filter((id) => targets.has(id) && !written.has(id)).length;
  }

  /** Whether a pass reads at most the current pixel of a layer. */
  function isHere({ reader, sampler }: Wire): boolean {
    const parts = passAt(reader)?.parts;
    return typeof parts === 'object' && parts.images.some((part) => part.isHere && part.image.sampler === sampler.name);
  }

  function whySeparate({ writer, reader, resource }: Wire, group: ReadonlySet<number>): SeparateReason | null {
    const from = passAt(writer);
    const to = passAt(reader);
    const target = targets.get(resource);
    if (from === null || to === null || target === undefined) return 'objects';
    if (viewed.has(resource)) return 'viewed';
    if (unfused.has(from.node) || unfused.has(to.node)) return 'switched';
    if (target.lifetime === 'persistent' || writers.get(resource)?.length !== 1 || writer >= reader) return 'kept';
    if (typeof to.parts === 'string') return to.parts;
    if (typeof from.parts === 'string') return from.parts;
    // Another pass of the group may read the layer too.
    const wires = [...group].flatMap(wiresInto).filter((other) => other.resource === resource);
    if (!wires.every(isHere)) return 'elsewhere';
    if (wires.some(({ sampler }) => sampler.fit !== 'none')) return 'fitted';
    if (from.view !== to.view || JSON.stringify(sizeOf(from)) !== JSON.stringify(sizeOf(to)) || fixedBases.has(resource)) return 'size';
    if (!readers.get(resource)?.every((place) => group.has(place))) return 'readers';
    const members = [...group].flatMap((place) => passAt(place) ?? []);
    if (readsElsewhere(from.parts) && members.some(({ parts }) => typeof parts !== 'string' && readsElsewhere(parts)))
      return 'neighborhoods';
    if (exceedsLimits([from, ...members])) return 'limits';
    const layers = layersRead([from, ...members]);
    if (layers > maxLayers && (maxLayers < 0 || layers > layersRead(members))) return 'memory';
    const last = Math.max(...group);
    const changes = from.reads.some((read) => writers.get(read)?.some((place) => place > writer && place < last));
    return changes ? 'order' : null;
  }

  return { wiresInto, whySeparate };
}

/** Targets of which other targets have a part of the size, unless these have a size that does not change with them. */
function basesOfParts(targets: Iterable<Target>): ReadonlySet<ResourceId> {
  const all = [...targets];
  const partial = new Set(all.flatMap(({ id, size }) => (isWhole(size) ? [] : [id])));
  return new Set(all.flatMap(({ size }) => (!isWhole(size) && partial.has(size.base) ? [size.base] : [])));
}

/** Whether a pass reads other pixels than the current one of a layer. */
function readsElsewhere({ images }: PassParts): boolean {
  return images.some(({ image, uses, isHere }) => !isHere && uses.has('color') && (image.kind === 'input' || image.kind === 'buffer'));
}

function exceedsLimits(passes: readonly ScheduledPass[]): boolean {
  const written = new Set(passes.map(({ target }) => target));
  const samplers = passes.flatMap((pass) => pass.samplers.filter(({ source }) => source.kind !== 'color' || !written.has(source.resource)));
  const uniforms = passes.reduce((sum, pass) => sum + pass.uniforms.length, 0);
  const vectors = samplers.length * SAMPLER_VECTORS + uniforms;
  return passes.length > MAX_PASSES || samplers.length > MAX_SAMPLERS || vectors > MAX_UNIFORM_VECTORS;
}

/** The places of operations, by the resources that `list` gives for them. */
function placesBy(
  operations: readonly ScheduledOperation[],
  list: (operation: ScheduledOperation) => readonly ResourceId[],
): ReadonlyMap<ResourceId, readonly number[]> {
  const places = new Map<ResourceId, number[]>();
  for (const [place, operation] of operations.entries()) {
    for (const id of list(operation)) {
      const known = places.get(id);
      if (known) known.push(place);
      else places.set(id, [place]);
    }
  }
  return places;
}
