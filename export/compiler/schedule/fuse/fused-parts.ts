import { fusedName } from '../../../glsl/fuse/fuse-passes.ts';
import type { FusedPart } from '../../../glsl/fuse/fused-part.ts';
import type { PassSampler, PassUniform, ResourceId } from '../../../program/program.ts';
import type { ScheduledPass } from '../scheduled.ts';

/** What fusion knows about layers. */
export interface LayerFacts {
  /** Textures whose alpha is 0 or 1 (`hardEdgedLayers`). */
  readonly hardEdged: ReadonlySet<ResourceId>;
  /** Targets, and images of their own size, whose textures are placed as the layers are. */
  readonly placed: ReadonlySet<ResourceId>;
}

/** Passes that become one, with what the result reads. */
export interface FusedParts {
  readonly parts: readonly FusedPart[];
  /** Samplers of textures, with the names that the fused shader gives them. */
  readonly samplers: readonly PassSampler[];
  /** Uniforms by their names in the fused shader. */
  readonly uniforms: Map<string, PassUniform>;
  /** Layers that the passes draw. */
  readonly drawn: ReadonlySet<ResourceId>;
}

/**
 * The parts of passes that one shader computes.
 *
 * @param given A layer whose color the shader has without a texture (`materialEffects`).
 */
export function fusedParts(passes: readonly ScheduledPass[], facts: LayerFacts, given: ResourceId | null = null): FusedParts {
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
    const drawn = given === null ? null : named(({ source }) => source.kind === 'color' && source.resource === given);
    const hardEdged = named(({ source }) => source.kind === 'color' && facts.hardEdged.has(source.resource));
    const aligned = named((sampler) => isAligned(sampler, facts));
    return { node: pass.node, parts: pass.parts, from, hardEdged, aligned, ...(drawn && { drawn }) };
  });
  return { parts, samplers, uniforms, drawn: new Set(drawnBy.keys()) };
}

/** Whether a sampler reads a texture at the positions of the pixels that are drawn. */
export function isAligned({ source, fit }: PassSampler, { placed }: LayerFacts): boolean {
  return source.kind === 'color' && fit === 'none' && placed.has(source.resource);
}
