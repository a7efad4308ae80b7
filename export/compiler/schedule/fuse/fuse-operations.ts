import { fusePasses } from '../../../glsl/fuse/fuse-passes.ts';
import type { Resource, ResourceId } from '../../../program/program.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from '../scheduled.ts';
import type { FuseInput } from './find-groups.ts';
import { fusedParts, isAligned, type LayerFacts } from './fused-parts.ts';
import { hardEdgedLayers } from './hard-edged-layers.ts';
import { findGroupsWithCopies, findGroupsWithoutCopies, type Recomputed } from './recompute.ts';
import type { SeparateWire } from './separate-wire.ts';
import { sinkEffects, type WhyNotOpaque } from './sink-effects.ts';
import { withoutTargets } from './without-targets.ts';

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
 * @param whyNotOpaque Why effects cannot be computed in the materials of a draw (ADR 55).
 */
export function fuseOperations(
  input: Omit<FuseInput, 'maxLayers' | 'repeated'>,
  opaqueImages: ReadonlySet<string>,
  bytesOf: (program: Pick<Fused, 'operations' | 'resources'>) => number,
  whyNotOpaque: WhyNotOpaque,
): Fused {
  const mostBytes = bytesOf(input);
  const { operations, resources } = input;
  const hardEdged = hardEdgedLayers(operations, opaqueImages);
  let fused: Fused = { operations, resources, separate: [] };
  for (const maxLayers of MAX_LAYERS) {
    for (const find of [findGroupsWithCopies, findGroupsWithoutCopies]) {
      fused = fuseGroups(sinkEffects(find({ ...input, maxLayers }), input, whyNotOpaque), hardEdged);
      if (bytesOf(fused) <= mostBytes) return fused;
    }
  }
  return fused;
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

/** A pass that stays alone, with a shader that reads textures where they are, as fused passes do. */
function withoutPlacement(pass: ScheduledPass, facts: LayerFacts): ScheduledPass {
  const { samplers, uniforms, shader } = fusePass([pass], facts);
  return { ...pass, samplers, uniforms, shader };
}

function fusePass(passes: readonly ScheduledPass[], facts: LayerFacts): ScheduledPass {
  const last = passes.at(-1);
  if (last === undefined) throw new Error('A group has passes.');
  const { parts, samplers, uniforms, drawn } = fusedParts(passes, facts);
  const shader = fusePasses(parts);
  // The size of a layer in the shader is that of the target, which perhaps no pass reads itself.
  if (shader.fragment.includes('uniform vec2 RENDERSIZE;'))
    uniforms.set('RENDERSIZE', { name: 'RENDERSIZE', type: 'vec2', source: { builtin: 'RENDERSIZE' } });
  // A fused pass does more than copy.
  const { copies: _, ...own } = last;
  return {
    ...own,
    reads: [...new Set(passes.flatMap(({ reads }) => reads))].filter((id) => !drawn.has(id) || id === last.target),
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
