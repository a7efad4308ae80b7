import { playSize, SIZE_STACK_BOTTOM } from '../../nodes/kit/play-size.ts';
import type { Program, Resource, ResourceId, SizeExpression } from '../program/program.ts';

/** Size of one view, for sizes in pixels and bytes. */
export interface ReferenceSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A phone in landscape. */
export const REFERENCE_SIZE: ReferenceSize = { widthPx: 1920, heightPx: 1080 };

export type Target = Extract<Resource, { kind: 'target' }>;

/** The parts of a program that the sizes of its targets depend on. */
export type Targeted = Pick<Program, 'resources' | 'slots' | 'taps'>;

/**
 * The render targets among the resources of a program.
 *
 * @example
 * targetsOf(program).length;
 */
export function targetsOf({ resources }: Pick<Program, 'resources'>): Target[] {
  return resources.filter((resource): resource is Target => resource.kind === 'target');
}

/** @returns The size of a target in pixels per view, or null if it depends on the size of a file. */
export function targetSize(target: Target, { slots }: Pick<Program, 'slots'>, { widthPx, heightPx }: ReferenceSize): ReferenceSize | null {
  if (target.size.base !== 'view') return null;
  const pixels = (expression: SizeExpression) => {
    const stack = new Float64Array(SIZE_STACK_BOTTOM + expression.length);
    const isSize = playSize(expression, widthPx, heightPx, putStart, slots, stack);
    return isSize ? Math.max(1, Math.floor(stack[SIZE_STACK_BOTTOM] ?? 1) || 1) : 1;
  };
  return { widthPx: pixels(target.size.width), heightPx: pixels(target.size.height) };
}

/** Bytes of a pixel of a target, by its format. */
export const BYTES_PER_PIXEL: Readonly<Record<Target['format'], number>> = { rgba8: 4, scene16f: 8, rgba16f: 8, rgba32f: 16, r32f: 4 };
const DEPTH_BYTES_PER_PIXEL = 4;

/**
 * Number of resolved depth textures of a multisampled target whose depth is read. They exist beside the depth of each sample and one byte
 * per sample and pixel.
 */
const RESOLVED_DEPTHS = 2;

/**
 * Texture memory of each target, per view. A multisampled target includes the textures that it is resolved to. Targets of equal size draw
 * into the same samples, one after the other, which count for the first of them; viewed targets have their own. A persistent target counts
 * twice, one that shares the texture of another one is 0.
 *
 * @returns Bytes, or null for a size that depends on a file.
 * @example
 * // 8 bits per channel, one sample, no depth: 4 bytes per pixel
 * targetBytes(program, { widthPx: 100, heightPx: 50 }).get('blur-a.layer'); // 20_000
 */
export function targetBytes(program: Targeted, reference: ReferenceSize): ReadonlyMap<ResourceId, number | null> {
  const viewed = new Set(Object.values(program.taps).map(({ color }) => color));
  const counted = new Set<string>();
  const bytesOf = (target: Target): number | null => {
    const { id, format, depth, depthRead, samples, lifetime, shares } = target;
    if (shares !== undefined) return 0;
    const size = targetSize(target, program, reference);
    if (size === null) return null;
    const isFirst = (kind: string): boolean => {
      const key = viewed.has(id) ? `${kind} ${id}` : `${kind} ${size.widthPx} ${size.heightPx}`;
      const before = counted.size;
      return counted.add(key).size > before;
    };
    const drawnSamples = samples > 1 && isFirst(format) ? samples : 0;
    const color = BYTES_PER_PIXEL[format] * (1 + drawnSamples);
    const depthSamples = depth === 'none' ? 0 : samples === 1 ? 1 : isFirst('depth') ? samples : 0;
    const resolvedDepth = samples > 1 && depthRead ? DEPTH_BYTES_PER_PIXEL * RESOLVED_DEPTHS + samples + 1 : 0;
    const copies = lifetime === 'persistent' ? 2 : 1;
    return size.widthPx * size.heightPx * (color + depthSamples * DEPTH_BYTES_PER_PIXEL + resolvedDepth) * copies;
  };
  return new Map(targetsOf(program).map((target) => [target.id, bytesOf(target)]));
}

/** Texture memory of all targets, per view. A size that depends on a file counts as that of the view. */
export function totalBytes(program: Targeted, reference: ReferenceSize = REFERENCE_SIZE): number {
  const bytes = targetBytes(program, reference);
  const unknown = reference.widthPx * reference.heightPx;
  return targetsOf(program).reduce((sum, { id, format }) => sum + (bytes.get(id) ?? unknown * BYTES_PER_PIXEL[format]), 0);
}

function putStart({ slot }: { readonly slot: number }, { numbers, slots }: Program['slots'], stack: Float64Array, at: number): void {
  stack[at] = numbers[slots[slot]?.offset ?? -1] ?? 0;
}

/** Texture memory of the image of what is behind glass (ADR 41): four samples with depth, and a copy with mip levels. */
export function behindGlassBytes(isScene: boolean, { widthPx, heightPx }: ReferenceSize): number {
  const color = BYTES_PER_PIXEL[isScene ? 'scene16f' : 'rgba8'];
  return Math.round(widthPx * heightPx * ((color + DEPTH_BYTES_PER_PIXEL) * 4 + (color * 4) / 3));
}
