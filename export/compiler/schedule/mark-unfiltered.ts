import type { Resource } from '../../program/program.ts';
import { isPass, type ScheduledOperation } from './scheduled.ts';
import { targetSizes, VIEW_SIZE } from './whole-size.ts';

/**
 * Marks the samplers of layers that passes of the same size read at the centers of pixels only. The normalized position of a center is
 * seldom a binary fraction, so filtering would mix in a little of a neighboring pixel, which a later division by a small alpha makes visible.
 */
export function markUnfiltered(operations: readonly ScheduledOperation[], resources: readonly Resource[]): ScheduledOperation[] {
  const sizes = new Map([...targetSizes(resources)].map(([id, size]) => [id, JSON.stringify(size)]));
  const viewSize = JSON.stringify(VIEW_SIZE);
  return operations.map((operation) => {
    if (!isPass(operation) || typeof operation.parts === 'string') return operation;
    const { parts, target, samplers } = operation;
    const size = target === 'screen' ? viewSize : sizes.get(target);
    const atCenters = new Set(parts.images.flatMap(({ image, reads }) => (reads.elsewhere === 0 ? [image.sampler] : [])));
    const marked = samplers.map((sampler) => {
      const { name, source, fit } = sampler;
      const isSame = source.kind === 'color' && fit === 'none' && sizes.get(source.resource) === size;
      return isSame && atCenters.has(name) ? { ...sampler, unfiltered: true as const } : sampler;
    });
    return { ...operation, samplers: marked };
  });
}
