import type { Material, MeshStandardMaterial } from 'three';
import { isTransmissive } from '../materials/layer-blending.ts';

/** Below this, what is blended lets light through rather than stopping it, as in `depth-twin.ts`. */
const SOLID_OPACITY = 0.5;

/** Whether the triangles of a material stop light. */
export function castsAsSolid(material: Material): boolean {
  return material.visible && !(material.transparent && material.opacity <= SOLID_OPACITY);
}

/** Whether light comes through a material, all over alike: a volume stops all of it, or none. */
export function isSeeThrough(material: Material): boolean {
  return material.visible && ((material.transparent && material.opacity < 1) || isTransmissive(material));
}

/** Whether a picture cuts holes into its triangles or moves them, which their volume does not follow. */
export function isShapedByPicture(material: Material): boolean {
  const { map, alphaMap, displacementMap, alphaTest, transparent } = material as Partial<MeshStandardMaterial> & Material;
  return Boolean(displacementMap) || ((alphaTest > 0 || transparent) && Boolean(map ?? alphaMap));
}
