import type { Resource, ResourceId, SizeExpression, TargetSize } from '../../program/program.ts';

export type Target = Extract<Resource, { kind: 'target' }>;

/** Size of the session's framebuffer: that of the view. */
export const VIEW_SIZE: TargetSize = { base: 'view', width: [{ op: 'width' }], height: [{ op: 'height' }] };

/**
 * The sizes of all targets. A target that has the whole size of another one gets the size of that, so that equal sizes are equal values: a
 * chain of images with the size of one file has one size.
 */
export function targetSizes(resources: readonly Resource[]): ReadonlyMap<ResourceId, TargetSize> {
  const sizes = new Map<ResourceId, TargetSize>();
  // Resources that a size refers to come earlier.
  for (const resource of resources) {
    if (resource.kind === 'target') sizes.set(resource.id, (isWhole(resource.size) && sizes.get(resource.size.base)) || resource.size);
  }
  return sizes;
}

/** Whether a size is that of its base. */
export function isWhole({ width, height }: TargetSize): boolean {
  return isSide(width, 'width') && isSide(height, 'height');
}

function isSide(expression: SizeExpression, side: 'width' | 'height'): boolean {
  const [token] = expression;
  return expression.length === 1 && typeof token === 'object' && 'op' in token && token.op === side;
}
