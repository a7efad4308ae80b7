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

/**
 * The render targets among the resources of a program.
 *
 * @example
 * targetsOf(program).length;
 */
export function targetsOf({ resources }: Program): Target[] {
  return resources.filter((resource): resource is Target => resource.kind === 'target');
}

/** @returns The size of a target in pixels per view, or null if it depends on the size of a file. */
export function targetSize(target: Target, { slots }: Program, { widthPx, heightPx }: ReferenceSize): ReferenceSize | null {
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
 * Texture memory of a target. A multisampled target includes its resolve textures, a persistent one counts twice, a shared one is 0.
 *
 * @returns Bytes per view, or null if the size depends on a file.
 * @example
 * // 8 bits per channel, one sample, no depth: 4 bytes per pixel
 * targetBytes(target, program, { widthPx: 100, heightPx: 50 }); // 20_000
 */
export function targetBytes(target: Target, program: Program, reference: ReferenceSize): number | null {
  if (target.shares !== undefined) return 0;
  const size = targetSize(target, program, reference);
  if (size === null) return null;
  const { samples } = target;
  const color = BYTES_PER_PIXEL[target.format] * (samples > 1 ? samples + 1 : 1);
  const copies = target.lifetime === 'persistent' ? 2 : 1;
  return size.widthPx * size.heightPx * (color + depthBytesPerPixel(target, program)) * copies;
}

function depthBytesPerPixel({ id, depth, samples }: Target, program: Program): number {
  if (depth === 'none') return 0;
  const drawn = DEPTH_BYTES_PER_PIXEL * samples;
  return samples > 1 && isDepthRead(id, program) ? drawn + DEPTH_BYTES_PER_PIXEL * RESOLVED_DEPTHS + samples + 1 : drawn;
}

function isDepthRead(id: ResourceId, { operations, resources }: Program): boolean {
  const sharing = new Set(resources.flatMap((r) => (r.kind === 'target' && (r.id === id || r.shares === id) ? [r.id] : [])));
  return operations.some(
    (operation) =>
      operation.kind === 'pass' && operation.samplers.some(({ source }) => source.kind === 'depth' && sharing.has(source.depth.resource)),
  );
}

function putStart({ slot }: { readonly slot: number }, { numbers, slots }: Program['slots'], stack: Float64Array, at: number): void {
  stack[at] = numbers[slots[slot]?.offset ?? -1] ?? 0;
}

/** Texture memory of the image of what is behind glass (ADR 41): four samples with depth, and a copy with mip levels. */
export function behindGlassBytes(isScene: boolean, { widthPx, heightPx }: ReferenceSize): number {
  const color = BYTES_PER_PIXEL[isScene ? 'scene16f' : 'rgba8'];
  return Math.round(widthPx * heightPx * ((color + DEPTH_BYTES_PER_PIXEL) * 4 + (color * 4) / 3));
}
