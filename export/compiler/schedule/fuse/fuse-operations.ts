import { fusedName, fusePasses } from '../../../glsl/fuse/fuse-passes.ts';
import type { FusedPart } from '../../../glsl/fuse/fused-part.ts';
import type { PassSampler, PassUniform, Resource, ResourceId } from '../../../program/program.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from '../scheduled.ts';
import { isWhole, type Target } from '../whole-size.ts';
import type { FuseInput } from './find-groups.ts';
import { hardEdgedLayers } from './hard-edged-layers.ts';
import { findGroupsWithCopies, findGroupsWithoutCopies, type Recomputed } from './recompute.ts';
import type { SeparateWire } from './separate-wire.ts';

export interface Fused {
  readonly operations: readonly ScheduledOperation[];
  /** Without the targets between passes that became one. */
  readonly resources: readonly Resource[];
  readonly separate: readonly SeparateWire[];
}

/** Values of `maxLayers`, tried in this order. With the last one nothing is fused. */
const MAX_LAYERS = [Number.POSITIVE_INFINITY, 8, 4, 2, -1];

/**
 * Replaces passes by fused ones, which draw the same pixels with fewer targets (ADR 43). A fused pass has the id and the node of its last
 * pass and runs at its place.
 *
 * All layers that a fused pass reads exist at the same time, where passes of their own need one after the other. So the memory of the
 * targets may grow; then fewer passes are fused.
 *
 * @param opaqueImages Ids of image assets without transparency.
 * @param bytesOf Memory of the targets.
 */
export function fuseOperations(
  input: Omit<FuseInput, 'maxLayers' | 'repeated'>,
  opaqueImages: ReadonlySet<string>,
  bytesOf: (program: Pick<Fused, 'operations' | 'resources'>) => number,
): Fused {
  const mostBytes = bytesOf(input);
  const { operations, resources } = input;
  const hardEdged = hardEdgedLayers(operations, opaqueImages);
  let fused: Fused = { operations, resources, separate: [] };
  for (const maxLayers of MAX_LAYERS) {
    for (const find of [findGroupsWithCopies, findGroupsWithoutCopies]) {
      fused = fuseGroups(find({ ...input, maxLayers }), hardEdged);
      if (bytesOf(fused) <= mostBytes) return fused;
    }
  }
  return fused;
}

/** What fusion knows about layers. */
interface LayerFacts {
  /** Textures whose alpha is 0 or 1 (`hardEdgedLayers`). */
  readonly hardEdged: ReadonlySet<ResourceId>;
  /** Targets, and images of their own size, whose textures are placed as the layers are. */
  readonly placed: ReadonlySet<ResourceId>;
}

function fuseGroups({ operations, resources, groups, separate }: Recomputed, hardEdged: ReadonlySet<ResourceId>): Fused {
  const placed = new Set(resources.filter(isPlaced).map(({ id }) => id));
  const facts = { hardEdged, placed };
  const fused = new Map<number, ScheduledPass>();
  const dropped = new Set<number>();
  for (const group of groups) {
    for (const place of group) dropped.add(place);
    const passes = group.flatMap((at) => operations[at] ?? []).filter(isPass);
    const pass = fusePass(passes, facts);
    fused.set(group.at(-1) ?? -1, pass);
  }
  const gone = new Set([...dropped].filter((place) => !fused.has(place)).flatMap((place) => operations[place]?.writes ?? []));
  const alone = (operation: ScheduledOperation): ScheduledOperation =>
    isPass(operation) && readsPlaced(operation, facts) ? withoutPlacement(operation, facts) : operation;
  return {
    operations: operations.flatMap((operation, place) => fused.get(place) ?? (dropped.has(place) ? [] : [alone(operation)])),
    resources: withoutTargets(resources, gone),
    separate,
  };
}

function isPlaced(resource: Resource): boolean {
  return resource.kind === 'target' || (resource.kind === 'external' && resource.domain === 'image');
}

/** Whether a pass reads a texture at the position of its own pixel. Passes that only copy stay as they are: the page often leaves them out. */
function readsPlaced({ parts, copies, samplers }: ScheduledPass, facts: LayerFacts): boolean {
  return typeof parts !== 'string' && !copies && samplers.some((sampler) => isAligned(sampler, facts));
}

function isAligned({ source, fit }: PassSampler, { placed }: LayerFacts): boolean {
  return source.kind === 'color' && fit === 'none' && placed.has(source.resource);
}

/** A pass that stays alone, with a shader that reads textures where they are, as fused passes do. */
function withoutPlacement(pass: ScheduledPass, facts: LayerFacts): ScheduledPass {
  const { samplers, uniforms, shader } = fusePass([pass], facts);
  return { ...pass, samplers, uniforms, shader };
}

function fusePass(passes: readonly ScheduledPass[], facts: LayerFacts): ScheduledPass {
  const last = passes.at(-1);
  if (last === undefined) throw new Error('A group has passes.');
  const drawnBy = new Map(passes.map(({ target }, i) => [target, i]));
  const samplers: PassSampler[] = [];
  const uniforms = new Map<string, PassUniform>();
  const parts = passes.map((pass, i): FusedPart => {
    const from = new Map<string, number>();
    for (const sampler of pass.samplers) {
      const drawn = sampler.source.kind === 'color' ? drawnBy.get(sampler.source.resource) : undefined;
      // What this or a later pass draws to is a persistent target, read as it was in the previous frame.
      if (drawn === undefined || drawn >= i) samplers.push({ ...sampler, name: fusedName(i, sampler.name) });
      else from.set(sampler.name, drawn);
    }
    for (const uniform of pass.uniforms) {
      const name = fusedName(i, uniform.name);
      uniforms.set(name, { ...uniform, name });
    }
    if (typeof pass.parts === 'string') throw new Error(`${pass.id} cannot be fused.`);
    const named = (holds: (sampler: PassSampler) => boolean) => new Set(pass.samplers.filter(holds).map(({ name }) => name));
    const hardEdged = named(({ source }) => source.kind === 'color' && facts.hardEdged.has(source.resource));
    return { node: pass.node, parts: pass.parts, from, hardEdged, aligned: named((sampler) => isAligned(sampler, facts)) };
  });
  const shader = fusePasses(parts);
  // The size of a layer in the shader is that of the target, which perhaps no pass reads itself.
  if (shader.fragment.includes('uniform vec2 RENDERSIZE;'))
    uniforms.set('RENDERSIZE', { name: 'RENDERSIZE', type: 'vec2', source: { builtin: 'RENDERSIZE' } });
  // A fused pass does more than copy.
  const { copies: _, ...own } = last;
  return {
    ...own,
    reads: [...new Set(passes.flatMap(({ reads }) => reads))].filter((id) => !drawnBy.has(id) || id === last.target),
    samplers,
    uniforms: [...uniforms.values()],
    shader,
    access: widestAccess(passes),
    nodes: [...new Set(passes.map(({ node }) => node))],
  };
}

const WIDEST_FIRST = ['persistent', 'resize', 'neighborhood', 'displaced', 'pointwise'] as const;

function widestAccess(passes: readonly ScheduledPass[]): NonNullable<ScheduledPass['access']> {
  return WIDEST_FIRST.find((access) => passes.some((pass) => pass.access === access)) ?? 'pointwise';
}

/** Drops targets. Sizes that are relative to a dropped one become relative to what its size is relative to. */
function withoutTargets(resources: readonly Resource[], dropped: ReadonlySet<ResourceId>): Resource[] {
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
