import type { Material, MeshStandardMaterial } from 'three';
import { isTransmissive } from '../materials/layer-blending.ts';

/** Opacity below which a blended material lets light pass, as in `depth-twin.ts`. */
const SOLID_OPACITY = 0.5;

/** Whether a material casts a full shadow: it is visible and more than half opaque. */
export function castsAsSolid(material: Material): boolean {
  return material.visible && !(material.transparent && material.opacity <= SOLID_OPACITY);
}

/** Whether a material lets light pass evenly. A volume blocks all of it or none. */
export function isSeeThrough(material: Material): boolean {
  return material.visible && ((material.transparent && material.opacity < 1) || isTransmissive(material));
}

/** Whether an image cuts or displaces its triangles, which volumes ignore. */
export function isShapedByPicture(material: Material): boolean {
  const { map, alphaMap, displacementMap, alphaTest, transparent } = material as Partial<MeshStandardMaterial> & Material;
  return Boolean(displacementMap) || ((alphaTest > 0 || transparent) && Boolean(map ?? alphaMap));
}
