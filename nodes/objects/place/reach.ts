import { Box3, type Matrix4, Sphere, Vector3 } from 'three';
import type { ObjectList } from '../../kit/scene-lists.ts';

// Filled and read within one call.
const scratchBox = new Box3();
const scratchPart = new Box3();
const scratchSphere = new Sphere();
const scratchOrigin = new Vector3();
const scratchAhead = new Vector3();

/**
 * Writes the bounding sphere of objects in their own space. Reads all geometries, so call it only at the start of a press.
 *
 * @returns False where there is nothing.
 */
export function writeBounds(out: Sphere, inputs: readonly ObjectList[]): boolean {
  scratchBox.makeEmpty();
  for (const { items } of inputs) {
    for (const { root, worldFromObject, hidden } of items) {
      if (hidden) continue;
      scratchPart.setFromObject(root);
      if (!scratchPart.isEmpty()) scratchBox.union(scratchPart.applyMatrix4(worldFromObject));
    }
  }
  if (scratchBox.isEmpty()) return false;
  scratchBox.getBoundingSphere(out);
  return true;
}

/**
 * The distance along a ray to the point that is nearest to the center of the objects' bounding sphere.
 *
 * @param worldFromRay Column-major 4×4, rigid; the ray follows its -z axis.
 * @param bounds The bounding sphere of the objects before they are placed.
 * @param worldFromPlaced The matrix that places the objects.
 * @returns Meters; infinity where the ray misses the sphere.
 */
export function distanceToBounds(worldFromRay: ArrayLike<number>, bounds: Sphere, worldFromPlaced: Matrix4): number {
  scratchSphere.copy(bounds).applyMatrix4(worldFromPlaced);
  const at = (i: number): number => worldFromRay[i] ?? 0;
  scratchOrigin.set(at(12), at(13), at(14));
  const toCenter = scratchSphere.center.sub(scratchOrigin);
  const alongM = toCenter.dot(scratchAhead.set(-at(8), -at(9), -at(10)));
  const { radius } = scratchSphere;
  // The center is ahead, or the ray starts inside.
  const isAhead = alongM > 0 || toCenter.length() <= radius;
  return isAhead && toCenter.lengthSq() - alongM * alongM <= radius * radius ? alongM : Number.POSITIVE_INFINITY;
}
