import { Box3, type Matrix4, Sphere, Vector3 } from 'three';
import type { ObjectList } from '../../kit/scene-lists.ts';

// Filled and read within one call.
const scratchBox = new Box3();
const scratchPart = new Box3();
const scratchSphere = new Sphere();
const scratchOrigin = new Vector3();
const scratchAhead = new Vector3();

/**
 * Whether a ray meets the bounding sphere of objects. For the start of a press, because it looks at all geometries.
 *
 * @param worldFromRay Column-major 4×4, rigid; the ray follows its -z axis.
 * @param worldFromPlaced What all objects are moved by.
 */
export function meetsObjects(worldFromRay: ArrayLike<number>, inputs: readonly ObjectList[], worldFromPlaced: Matrix4): boolean {
  scratchBox.makeEmpty();
  for (const { items } of inputs) {
    for (const { root, worldFromObject } of items) {
      scratchPart.setFromObject(root);
      if (!scratchPart.isEmpty()) scratchBox.union(scratchPart.applyMatrix4(worldFromObject));
    }
  }
  if (scratchBox.isEmpty()) return false;
  scratchBox.getBoundingSphere(scratchSphere).applyMatrix4(worldFromPlaced);
  const at = (i: number): number => worldFromRay[i] ?? 0;
  scratchOrigin.set(at(12), at(13), at(14));
  const toCenter = scratchSphere.center.sub(scratchOrigin);
  const alongM = toCenter.dot(scratchAhead.set(-at(8), -at(9), -at(10)));
  const { radius } = scratchSphere;
  // The center is ahead, or the ray starts inside.
  return (alongM > 0 || toCenter.length() <= radius) && toCenter.lengthSq() - alongM * alongM <= radius * radius;
}
