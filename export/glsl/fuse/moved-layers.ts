import { colorFunction, type Image } from '../link/images.ts';
import type { FusedPart } from './fused-part.ts';

/** A layer that a fused shader computes at another pixel than the current one. */
export interface MovedLayer {
  /** The passes that compute it, in order: the pass that draws the layer and those that only this pass depends on. */
  readonly passes: readonly number[];
  /** Whether passes of the shader use `gl_FragCoord` and `discard`, which the passes of the layer set. */
  readonly keepsCoord: boolean;
  readonly keepsDiscard: boolean;
}

/** By `movedKey`. */
export type MovedLayers = ReadonlyMap<string, MovedLayer>;

/** The normalized position for which passes of moved layers are computed: the center of a pixel. */
export const MOVED_POSITION = 'scrim_at';

export function movedKey(reader: number, sampler: string): string {
  return `${reader} ${sampler}`;
}

export function layerName(index: number): string {
  return `b${index}_layer`;
}

export function mainName(index: number): string {
  return `b${index}_main`;
}

/** Finds the layers that passes read at other pixels. All readers of a layer read it for the same pixel. */
export function movedLayers(passes: readonly FusedPart[]): MovedLayers {
  /** The read for which a pass is computed; none for the current pixel. */
  const readOf = new Map<number, string>();
  const layers = new Map<string, number[]>();
  for (let reader = passes.length - 1; reader >= 0; reader -= 1) {
    const { parts, from } = passes[reader] ?? {};
    const inherited = readOf.get(reader);
    for (const [sampler, producer] of from ?? []) {
      const isHere = parts?.images.some((part) => part.isHere && part.image.sampler === sampler) ?? true;
      const read = isHere ? inherited : movedKey(reader, sampler);
      if (read !== undefined) readOf.set(producer, read);
    }
    if (inherited !== undefined) layers.set(inherited, [reader, ...(layers.get(inherited) ?? [])]);
  }
  const keepsCoord = passes.some(({ parts }) => parts.usesFragCoord);
  const keepsDiscard = passes.some(({ parts }) => parts.discards);
  return new Map([...layers].map(([read, members]) => [read, { passes: members, keepsCoord, keepsDiscard }]));
}

export function passesMoved(layers: MovedLayers): ReadonlySet<number> {
  return new Set([...layers.values()].flatMap(({ passes }) => passes).sort((a, b) => a - b));
}

/**
 * The function that computes a layer at the pixel of a position and returns its color. Positions beyond the edges are clamped to them, or
 * wrapped if the image repeats, as for a texture. What the passes share with their reader is restored.
 */
export function movedReadText(image: Image, color: string, { passes, keepsCoord, keepsDiscard }: MovedLayer): string {
  const kept = [
    `vec2 at = ${MOVED_POSITION};`,
    'vec4 before = scrim_fragColor;',
    ...(keepsCoord ? ['vec4 coord = scrim_fragCoord;'] : []),
    ...(keepsDiscard ? ['bool discarded = scrim_discarded;'] : []),
  ];
  const restored = [
    `${MOVED_POSITION} = at;`,
    'scrim_fragColor = before;',
    ...(keepsCoord ? ['scrim_fragCoord = coord;'] : []),
    ...(keepsDiscard ? ['scrim_discarded = discarded;'] : []),
  ];
  const pixel = `clamp(floor(${image.repeat ? 'fract(uv)' : 'uv'} * RENDERSIZE), vec2(0.0), RENDERSIZE - 1.0)`;
  const statements = [
    ...kept,
    `${MOVED_POSITION} = (${pixel} + 0.5) / RENDERSIZE;`,
    ...passes.map((pass) => `${mainName(pass)}();`),
    ...restored,
    `return ${color};`,
  ];
  return `vec4 ${colorFunction(image)}(vec2 uv) {\n${statements.map((statement) => `  ${statement}`).join('\n')}\n}`;
}
