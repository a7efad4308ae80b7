import { fusePasses } from '../../../glsl/fuse/fuse-passes.ts';
import { materialEffects } from '../../../glsl/fuse/material-effects.ts';
import type { PassParts } from '../../../glsl/link/link-parts.ts';
import type { BuiltinUniform, PassSampler, Resource, ResourceId } from '../../../program/program.ts';
import { isDrawOperation, isPass, type ScheduledDraw, type ScheduledOperation, type ScheduledPass } from '../scheduled.ts';
import { isWhole, type Target } from '../whole-size.ts';
import { type FuseInput, isUnstable, type PassGroup } from './find-groups.ts';
import { fusedParts, type LayerFacts } from './fused-parts.ts';
import { originalId, type Recomputed } from './recompute.ts';
import type { SeparateReason } from './separate-wire.ts';
import { withoutTargets } from './without-targets.ts';

/** Why effects cannot be computed in the materials of a draw; null if each pixel that it colors shows one opaque surface. */
export type WhyNotOpaque = (draw: ScheduledDraw) => SeparateReason | null;

type Given = Pick<FuseInput, 'viewed' | 'unfused'>;

/** Automatic uniforms that are the same for all pixels. */
const OF_FRAME: ReadonlySet<BuiltinUniform> = new Set(['TIME', 'TIMEDELTA', 'FRAMEINDEX', 'PASSINDEX']);

/** Nothing is known about textures, because the effects read none. */
const NO_FACTS: LayerFacts = { hardEdged: new Set(), placed: new Set() };

/** What a rasterizer tells of a triangle: a pass always draws the front of one. */
const OF_TRIANGLE = /\bgl_(FrontFacing|PointCoord)\b/;

/**
 * The most tables that materials can read: those of one Curves node. With six maps of a glTF material, the environment, room depth and three
 * shadows, these are the 16 textures that every device has.
 */
const MOST_TABLES = 5;

/** A group of passes with the draw whose layer it reads. */
interface Above {
  readonly passes: readonly ScheduledPass[];
  readonly draw: ScheduledDraw;
  readonly layer: Target;
}

/**
 * Lets draws compute the passes over their layers in the materials of their objects, where that gives the same image (ADR 55): the layer and
 * the passes are gone, and the draw is where the last pass was. The other wires from draws get the reason why not.
 */
export function sinkEffects(found: Recomputed, given: Given, whyNotOpaque: WhyNotOpaque): Recomputed {
  const { operations, resources } = found;
  const { sunk, reasons } = findSunk(found, given, whyNotOpaque);
  const draws = new Map(sunk.map(({ group, draw }) => [group.at(-1), draw]));
  const dropped = new Set(sunk.flatMap(({ group, from }) => [...group, from]));
  const drawnInto = new Set(sunk.flatMap(({ draw }) => draw.writes));
  const gone = new Set([...dropped].flatMap((place) => operations[place]?.writes ?? []).filter((id) => !drawnInto.has(id)));
  const left = [...operations.keys()].filter((place) => draws.has(place) || !dropped.has(place));
  const places = new Map(left.map((place, at) => [place, at]));
  return {
    ...found,
    operations: left.flatMap((place) => draws.get(place) ?? operations[place] ?? []),
    resources: withoutTargets(resources, gone).map((resource) => (drawnInto.has(resource.id) ? withDepth(resource) : resource)),
    groups: found.groups.filter((group) => !draws.has(group.at(-1))).map((group) => group.map((place) => places.get(place) ?? -1)),
    separate: found.separate.flatMap((wire) => {
      if (gone.has(wire.resource)) return [];
      const reason = wire.reason === 'objects' ? reasons.get(wireKey(wire.resource, wire.reader)) : undefined;
      return [reason === undefined ? wire : { ...wire, reason }];
    }),
  };
}

/** Passes that a draw computes. */
interface Sunk {
  readonly group: PassGroup;
  /** Place of the draw before. */
  readonly from: number;
  /** The draw with the effects. */
  readonly draw: ScheduledDraw;
}

function findSunk(
  { operations, resources, groups }: Recomputed,
  given: Given,
  whyNotOpaque: WhyNotOpaque,
): { readonly sunk: readonly Sunk[]; readonly reasons: ReadonlyMap<string, SeparateReason> } {
  const targets = new Map(resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource] as const] : [])));
  const draws = new Map<string, { readonly draw: ScheduledDraw; readonly from: number }>();
  for (const [from, draw] of operations.entries()) if (isDrawOperation(draw)) draws.set(draw.target, { draw, from });
  const facts = { ...given, targets, readers: readersOf(operations), whyNotOpaque };
  const grouped = new Set(groups.flat());
  const alone = [...operations.keys()].filter((place) => !grouped.has(place)).map((place) => [place]);
  const sunk: Sunk[] = [];
  const reasons = new Map<string, SeparateReason>();
  for (const group of [...groups, ...alone]) {
    const passes = group.flatMap((place) => operations[place] ?? []).filter(isPass);
    for (const id of new Set(passes.flatMap(({ reads }) => reads))) {
      const drawn = draws.get(id);
      const layer = targets.get(id);
      if (drawn === undefined || layer === undefined) continue;
      const above = { passes, draw: drawn.draw, layer };
      const reason = whySeparate(above, facts);
      if (reason === null) sunk.push({ group, from: drawn.from, draw: withEffects(above) });
      else for (const { id: reader } of passes) reasons.set(wireKey(id, originalId(reader)), reason);
    }
  }
  return { sunk, reasons };
}

function wireKey(resource: ResourceId, reader: string): string {
  return `${resource} ${reader}`;
}

function withDepth(resource: Resource): Resource {
  return resource.kind === 'target' ? { ...resource, depth: 'window' } : resource;
}

/** How many operations read each resource. */
function readersOf(operations: readonly ScheduledOperation[]): ReadonlyMap<ResourceId, number> {
  const counts = new Map<ResourceId, number>();
  for (const { reads } of operations) for (const id of new Set(reads)) counts.set(id, (counts.get(id) ?? 0) + 1);
  return counts;
}

interface Facts extends Given {
  readonly readers: ReadonlyMap<ResourceId, number>;
  readonly targets: ReadonlyMap<ResourceId, Target>;
  readonly whyNotOpaque: WhyNotOpaque;
}

function whySeparate({ passes, draw, layer }: Above, facts: Facts): SeparateReason | null {
  const { targets, viewed, unfused } = facts;
  const nodes = [draw.node, ...(draw.occlusion ? [draw.occlusion.node] : []), ...passes.map(({ node }) => node)];
  const parts = passes.flatMap((pass) => (typeof pass.parts === 'string' ? [] : [pass.parts]));
  const unlinked = passes.find((pass) => typeof pass.parts === 'string')?.parts;
  const readers = passes.filter(({ reads }) => reads.includes(layer.id));
  const last = passes.at(-1);
  if (last === undefined) return 'objects';
  if (viewed.has(layer.id)) return 'viewed';
  if (nodes.some((node) => unfused.has(node))) return 'switched';
  if (typeof unlinked === 'string') return unlinked;
  if (facts.readers.get(layer.id) !== readers.length) return 'readers';
  if (!readers.every((pass) => isReadHere(pass, layer.id))) return 'elsewhere';
  if (passes.some((pass) => readsOthers(pass, layer.id, passes))) return 'textures';
  if (readers.some(isUnstable)) return 'unstable';
  if (!parts.every(ignoresPosition)) return 'position';
  if (!parts.every(keepsTransparent)) return 'background';
  if (layer.samples > 1) return 'samples';
  if (new Set(passes.flatMap(({ samplers }) => samplers.flatMap(tableOf))).size > MOST_TABLES) return 'limits';
  const target = last.target === 'screen' ? null : targets.get(last.target);
  if (target === undefined || !isWhole(layer.size) || (target && !fits(target))) return 'size';
  // What the draw reads is complete before all draws.
  if (draw.reads.some((id) => targets.has(id))) return 'order';
  return facts.whyNotOpaque(draw);
}

/** Whether a pass reads only the current pixel of a layer. */
function isReadHere({ parts, samplers }: ScheduledPass, layer: ResourceId): boolean {
  const names = new Set(samplers.flatMap(({ name, source }) => (source.kind === 'color' && source.resource === layer ? [name] : [])));
  return typeof parts === 'object' && parts.images.every(({ image, isHere }) => isHere || !names.has(image.sampler));
}

/** Whether a pass reads an image besides a layer, what other passes of the group draw, and tables. */
function readsOthers({ samplers }: ScheduledPass, layer: ResourceId, passes: readonly ScheduledPass[]): boolean {
  const drawn = new Set([layer, ...passes.map(({ target }) => target)]);
  return samplers.some(({ source }) => source.kind !== 'table' && (source.kind !== 'color' || !drawn.has(source.resource)));
}

/** Whether a pass computes the same color wherever its pixel is. */
function ignoresPosition({ moves, usesFragCoord, projects, builtins, images, functions, body }: PassParts): boolean {
  const readsSize = images.some(({ uses }) => uses.has('size'));
  const readsTriangle = [...functions.lines, ...body.lines].some((line) => OF_TRIANGLE.test(line));
  return moves && !usesFragCoord && !projects && !readsSize && !readsTriangle && builtins.every((name) => OF_FRAME.has(name));
}

/** Whether a pass hands alpha on, and multiplies its color with it: what is transparent stays so. */
function keepsTransparent({ keptAlpha, output, format }: PassParts): boolean {
  return keptAlpha !== null && output.color !== 'scrim_fragColor' && (format === 'rgba8' ? output.clamps : format === 'scene16f');
}

/** Whether objects can be drawn to the target of a pass. */
function fits({ size, domain, samples, lifetime }: Target): boolean {
  return isWhole(size) && size.base === 'view' && domain === 'view' && samples === 1 && lifetime === 'frame';
}

function tableOf({ source }: PassSampler): ResourceId[] {
  return source.kind === 'table' ? [source.resource] : [];
}

function withEffects({ passes, draw, layer }: Above): ScheduledDraw {
  const { parts, uniforms, samplers, drawn } = fusedParts(passes, NO_FACTS, layer.id);
  const tables = samplers.filter(({ source }) => source.kind === 'table');
  const read = passes.flatMap(({ reads }) => reads).filter((id) => id !== layer.id && !drawn.has(id));
  const target = passes.at(-1)?.target ?? 'screen';
  const outputs = Object.entries(draw.outputs).map(([port]) => [
    port,
    { kind: 'layer', layer: { color: target, depth: { resource: target, encoding: 'window' } } },
  ]);
  return {
    ...draw,
    reads: [...new Set([...draw.reads, ...read, ...tables.flatMap(tableOf)])],
    writes: target === 'screen' ? [] : [target],
    outputs: target === 'screen' ? {} : Object.fromEntries(outputs),
    target,
    effects: {
      nodes: [...new Set(passes.map(({ node }) => node))],
      text: materialEffects(parts, layer.format),
      uniforms: [...uniforms.values()].filter(({ name }) => name !== 'PASSINDEX'),
      ...(tables.length > 0 && { samplers: tables }),
      trial: fusePasses(fusedParts(passes, NO_FACTS).parts),
    },
  };
}
