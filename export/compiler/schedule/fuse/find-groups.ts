import type { ImagePart, PassParts } from '../../../glsl/link/link-parts.ts';
import type { PassSampler, Resource, ResourceId, TargetSize } from '../../../program/program.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from '../scheduled.ts';
import { isWhole, type Target, targetSizes, VIEW_SIZE } from '../whole-size.ts';
import type { SeparateReason, SeparateWire } from './separate-wire.ts';
import { UNSTABLE_SHADERS } from './unstable-shaders.ts';

/** Passes that become one: indices of operations, ascending. The last one gives the target. */
export type PassGroup = readonly number[];

export interface FoundGroups {
  readonly groups: readonly PassGroup[];
  /** Wires into passes that stay as they are. */
  readonly separate: readonly SeparateWire[];
  /** The group of each pass that belongs to one, as an object to compare. */
  readonly groupOf: ReadonlyMap<number, ReadonlyMap<number, unknown>>;
}

export interface FuseInput {
  readonly operations: readonly ScheduledOperation[];
  readonly resources: readonly Resource[];
  /** Targets that something outside of the program shows. */
  readonly viewed: ReadonlySet<ResourceId>;
  /** Nodes whose passes keep shaders of their own. */
  readonly unfused: ReadonlySet<string>;
  /** Layers that a pass may compute for each of several pixels that it reads. */
  readonly repeated: ReadonlySet<ResourceId>;
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
 * The members of a growing group. Each is computed for the current pixel (null), or for the pixel of one read of another member (`movedRead`).
 */
type Group = ReadonlyMap<number, string | null>;

/**
 * Finds the passes that can be drawn by one shader. Each group grows from its last pass towards the sources: a pass joins if only passes of
 * the group read its layer, each at the current pixel, or one of them once at the center of another pixel. So no pixel is computed twice, and diamonds become
 * one pass. Time is linear in the number of operations, because the size of groups is limited.
 */
export function findGroups(input: FuseInput): FoundGroups {
  const { operations } = input;
  const rules = createRules(input);
  const groupOf = new Map<number, Group>();
  for (let root = operations.length - 1; root >= 0; root -= 1) {
    const operation = operations[root];
    if (operation === undefined || !isPass(operation) || groupOf.has(root)) continue;
    const group = grow(root, rules);
    for (const member of group.keys()) groupOf.set(member, group);
  }
  const separate = operations.flatMap((operation, reader) =>
    rules.wiresInto(reader).flatMap((wire): SeparateWire[] => {
      const group = groupOf.get(reader) ?? new Map([[reader, null]]);
      const reason = group.has(wire.writer) ? null : rules.whySeparate(wire, group);
      const writer = operations[wire.writer];
      if (reason === null || writer === undefined || !isPass(operation)) return [];
      return [{ resource: wire.resource, writer: writer.id, reader: operation.id, node: operation.node, reason }];
    }),
  );
  const groups = [...new Set(groupOf.values())].filter((group) => group.size > 1);
  return { groups: groups.map((group) => [...group.keys()].sort((a, b) => a - b)), separate, groupOf };
}

function grow(root: number, { wiresInto, whySeparate, placeOf }: Rules): Group {
  const group = new Map<number, string | null>([[root, null]]);
  let open = [...wiresInto(root)];
  for (let grows = true; grows; ) {
    grows = false;
    const left: Wire[] = [];
    for (const wire of open) {
      if (group.has(wire.writer)) continue;
      if (whySeparate(wire, group) === null) {
        group.set(wire.writer, placeOf(wire, group));
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
  whySeparate(wire: Wire, group: Group): SeparateReason | null;
  /** For which pixel the writer of a wire is computed in the group of its reader. */
  placeOf(wire: Wire, group: Group): string | null;
}

function createRules({ operations, resources, viewed, unfused, repeated, maxLayers }: FuseInput): Rules {
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

  function imageOf({ reader, sampler }: Wire): ImagePart | undefined {
    const parts = passAt(reader)?.parts;
    return typeof parts === 'object' ? parts.images.find(({ image }) => image.sampler === sampler.name) : undefined;
  }

  /** Whether a pass reads a layer at the current pixel only, or at the centers of a few pixels. */
  function isAtPixels(wire: Wire): boolean {
    const image = imageOf(wire);
    return (
      image !== undefined &&
      (image.isHere || (image.reads.elsewhere === 0 && Number.isFinite(image.reads.texels) && image.reads.texels > 0))
    );
  }

  function isReadOnce(wire: Wire): boolean {
    const image = imageOf(wire);
    return image !== undefined && (image.isHere || readsOneTexel(image));
  }

  function placeOf(wire: Wire, group: Group): string | null {
    return imageOf(wire)?.isHere ? (group.get(wire.reader) ?? null) : `${wire.reader} ${wire.sampler.name}`;
  }

  /** Whether a pass can be computed for another pixel with the same color: what it reads are pixels of layers of its size, without filtering. */
  function isMovable(pass: ScheduledPass): boolean {
    const { parts, samplers } = pass;
    if (typeof parts === 'string' || !parts.moves) return false;
    const size = JSON.stringify(sizeOf(pass));
    return samplers.every(({ name, source, fit }) => {
      if (source.kind === 'table') return true;
      const image = parts.images.find((part) => part.image.sampler === name);
      if (source.kind !== 'color' || fit !== 'none' || image?.reads.elsewhere !== 0) return false;
      return targets.has(source.resource) && JSON.stringify(sizes.get(source.resource)) === size;
    });
  }

  function whySeparate(wire: Wire, group: Group): SeparateReason | null {
    const { writer, reader, resource } = wire;
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
    const wires = [...group.keys()].flatMap(wiresInto).filter((other) => other.resource === resource);
    const places = new Set(wires.map((other) => placeOf(other, group)));
    if (!wires.every(isAtPixels) || places.size > 1) return 'elsewhere';
    if (wires.some(({ sampler }) => sampler.fit !== 'none')) return 'fitted';
    if (from.view !== to.view || JSON.stringify(sizeOf(from)) !== JSON.stringify(sizeOf(to)) || fixedBases.has(resource)) return 'size';
    if (!places.has(null) && !isMovable(from)) return 'moved';
    if (isUnstable(to)) return 'unstable';
    if (!repeated.has(resource) && !wires.every(isReadOnce)) return 'cost';
    const needsTexture = wires.some((other) => isUnstable(passAt(other.reader)));
    if (needsTexture || !readers.get(resource)?.every((place) => group.has(place))) return 'readers';
    const members = [...group.keys()].flatMap((place) => passAt(place) ?? []);
    if (readsElsewhere(from.parts) && members.some(({ parts }) => typeof parts !== 'string' && readsElsewhere(parts)))
      return 'neighborhoods';
    if (exceedsLimits([from, ...members], targets)) return 'limits';
    const layers = layersRead([from, ...members]);
    if (layers > maxLayers && (maxLayers < 0 || layers > layersRead(members))) return 'memory';
    const last = Math.max(...group.keys());
    const changes = from.reads.some((read) => writers.get(read)?.some((place) => place > writer && place < last));
    return changes ? 'order' : null;
  }

  return { wiresInto, whySeparate, placeOf };
}

/** Targets of which other targets have a part of the size, unless these have a size that does not change with them. */
function basesOfParts(targets: Iterable<Target>): ReadonlySet<ResourceId> {
  const all = [...targets];
  const partial = new Set(all.flatMap(({ id, size }) => (isWhole(size) ? [] : [id])));
  return new Set(all.flatMap(({ size }) => (!isWhole(size) && partial.has(size.base) ? [size.base] : [])));
}

/** Whether a pass makes large steps of the rounding before it, which devices do differently. */
export function isUnstable(pass: ScheduledPass | null): boolean {
  return pass !== null && typeof pass.parts !== 'string' && UNSTABLE_SHADERS.includes(pass.parts.file);
}

/** Whether a pass reads one pixel of an image, at its center. */
function readsOneTexel({ reads }: ImagePart): boolean {
  return reads.elsewhere === 0 && reads.here + reads.texels === 1;
}

/** Whether a pass reads several pixels of a layer, or one between the centers of pixels. */
function readsElsewhere({ images }: PassParts): boolean {
  const isLayer = ({ image, uses }: ImagePart) => uses.has('color') && (image.kind === 'input' || image.kind === 'buffer');
  return images.some((part) => isLayer(part) && !part.isHere && !readsOneTexel(part));
}

function exceedsLimits(passes: readonly ScheduledPass[], targets: ReadonlyMap<ResourceId, Target>): boolean {
  // A persistent target is sampled as it was in the previous frame.
  const written = new Set(passes.flatMap(({ target }) => (targets.get(target)?.lifetime === 'persistent' ? [] : [target])));
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
