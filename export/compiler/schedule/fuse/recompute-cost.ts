import type { TargetFormat } from '../../../program/program.ts';
import type { ScheduledPass } from '../scheduled.ts';

/**
 * Operations in the time in which a GPU stores or reads four bytes per pixel. Phones and headsets do 60 to 160: the GPU of a Quest 3
 * computes 3 · 10¹² per second at 77 GB/s, that of a cheap phone 0.4 · 10¹² at 17 to 34 GB/s. Half of the least, because the operations are estimated.
 */
const TEXEL_OPERATIONS = 32;

/** Operations of a read of a texel that is in the cache: filtering and addressing. */
const FETCH_OPERATIONS = 8;

/** Operations between two passes of a shader: rounding, division by alpha and multiplication with it. */
const BOUNDARY_OPERATIONS = 24;

const TEXEL_WEIGHTS: Readonly<Record<TargetFormat, number>> = { rgba8: 1, r32f: 1, scene16f: 2, rgba16f: 2, rgba32f: 4 };

/** A layer that several shaders, or one for several pixels, could compute instead of reading a texture. */
export interface Recomputation {
  /** The passes that compute the layer, as one shader. */
  readonly passes: readonly ScheduledPass[];
  readonly format: TargetFormat;
  /** For each shader that reads the layer: the number of its pixels that one pixel reads. */
  readonly readers: readonly number[];
}

/**
 * Whether to compute a layer anew in each of its readers costs less than to store it once and to read it in each of them. Both are estimated
 * from the linked code, in arithmetic operations per pixel.
 *
 * A shader that reads neighboring pixels finds most of them in the cache, so its layer is read from memory once.
 */
export function isRecomputed({ passes, format, readers }: Recomputation): boolean {
  const drawn = new Set(passes.map(({ target }) => target));
  const isOwn = ({ samplers }: ScheduledPass, name: string) =>
    samplers.some((sampler) => sampler.name === name && sampler.source.kind === 'color' && drawn.has(sampler.source.resource));
  let computing = 0;
  const textures = new Set<string>();
  for (const pass of passes) {
    if (typeof pass.parts === 'string') return false;
    computing += pass.parts.operations + BOUNDARY_OPERATIONS;
    for (const { image, reads } of pass.parts.images) {
      if (isOwn(pass, image.sampler)) continue;
      computing += (reads.here + reads.texels + reads.elsewhere) * FETCH_OPERATIONS;
      for (const { name, source } of pass.samplers) if (name === image.sampler) textures.add(JSON.stringify(source));
    }
  }
  const reading = textures.size * TEXEL_OPERATIONS;
  const pixels = readers.reduce((sum, count) => sum + count, 0);
  const texel = TEXEL_WEIGHTS[format] * TEXEL_OPERATIONS;
  const stored = computing + reading + texel * (1 + readers.length) + pixels * FETCH_OPERATIONS;
  return pixels * computing + readers.length * reading < stored;
}
