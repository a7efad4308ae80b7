import {
  BasicDepthPacking,
  DoubleSide,
  type Material,
  MeshDepthMaterial,
  type MeshStandardMaterial,
  NoBlending,
  NormalBlending,
} from 'three';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { castsTranslucentShadow } from './translucent-shadow-twin.ts';
import { setMap, type Twin } from './twins.ts';

/** Alpha below which a blended surface lets light pass. */
const SOLID_ALPHA = 0.5;

/** Alpha below which a blended surface is invisible. */
const SEEN_ALPHA = 1 / 255;

/**
 * Creates a material that draws only depth of the master, including holes by alpha test and displacement.
 *
 * - `surface`: for phantoms, and for objects whose colors are drawn afterwards. It is a little behind the surface, so that colors on the
 * surface pass the depth test.
 * - `shadow`: both sides, because a single-sided wall casts a shadow in either direction. Transparent materials are excluded; they dim the
 * light (`translucent-shadow-twin.ts`).
 * - `solid`: as `surface`, but blended materials have depth only where alpha is at least one half.
 * - `blended`: only for blended materials that write no depth with their colors. Drawn after all others, it adds their depth to the layer.
 */
export function createDepthTwin(master: Material, use: 'surface' | 'shadow' | 'solid' | 'blended', clip: ShaderPatch | null = null): Twin {
  const material = new MeshDepthMaterial();
  // Some shadow filters read the color that it writes: 1 minus the depth.
  material.depthPacking = BasicDepthPacking;
  material.colorWrite = use === 'shadow';
  material.polygonOffset = use === 'surface' || use === 'solid';
  material.polygonOffsetFactor = 1;
  material.polygonOffsetUnits = 1;
  if (use === 'blended') {
    // three.js draws transparent materials last.
    material.transparent = true;
    material.blending = NoBlending;
  }
  if (clip) patchMaterial(material, null, [clip]);
  const leastAlpha = use === 'solid' ? SOLID_ALPHA : use === 'blended' ? SEEN_ALPHA : 0;
  function sync(): void {
    // Materials without one of these, such as lines, have no such holes.
    const from = master as Partial<MeshStandardMaterial> & Material;
    const alphaTest = from.alphaTest > 0 ? from.alphaTest : from.transparent ? leastAlpha : 0;
    material.visible =
      from.visible && !(use === 'shadow' && castsTranslucentShadow(master)) && !(use === 'blended' && !blendsWithoutDepth(master));
    material.side = use === 'shadow' ? (from.shadowSide ?? DoubleSide) : from.side;
    material.wireframe = from.wireframe ?? false;
    material.opacity = from.opacity;
    material.alphaTest = alphaTest;
    material.displacementScale = from.displacementScale ?? 1;
    material.displacementBias = from.displacementBias ?? 0;
    setMap(material, 'map', alphaTest > 0 ? from.map : null);
    setMap(material, 'alphaMap', alphaTest > 0 ? from.alphaMap : null);
    setMap(material, 'displacementMap', from.displacementMap);
  }
  sync();
  return { material, sync, dispose: () => material.dispose() };
}

/** Whether a material covers its background without writing depth. Additive materials cover nothing. */
export function blendsWithoutDepth({ transparent, depthWrite, blending }: Material): boolean {
  return transparent && !depthWrite && blending === NormalBlending;
}
