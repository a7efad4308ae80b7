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

/** Below this, a surface that is blended lets light through rather than stopping it. */
const SOLID_ALPHA = 0.5;

/** Below this, of what is blended nothing is to be seen. */
const SEEN_ALPHA = 1 / 255;

/**
 * Draws the master's shape into depth alone: holes cut by its alpha test, moved by its displacement map.
 *
 * - `surface`: for what stands for a real thing or is drawn again in its colors. It lies a little behind the surface itself, so
 *   that what lies on the surface wins over it.
 * - `shadow`: both sides, because a single-sided wall casts a shadow whichever way it faces; what is see-through dims the light instead
 *   (`translucent-shadow-twin.ts`).
 * - `solid`: as `surface`, but what is blended is there where its alpha is above one half.
 * - `blended`: what is blended and writes no depth with its colors, after all of these: so that its layer has it.
 */
export function createDepthTwin(master: Material, use: 'surface' | 'shadow' | 'solid' | 'blended', clip: ShaderPatch | null = null): Twin {
  const material = new MeshDepthMaterial();
  // In a shadow map, some filters read what it writes: 1 less the depth.
  material.depthPacking = BasicDepthPacking;
  material.colorWrite = use === 'shadow';
  material.polygonOffset = use === 'surface' || use === 'solid';
  material.polygonOffsetFactor = 1;
  material.polygonOffsetUnits = 1;
  if (use === 'blended') {
    // three draws whatever is transparent after all that is not.
    material.transparent = true;
    material.blending = NoBlending;
  }
  if (clip) patchMaterial(material, null, [clip]);
  const leastAlpha = use === 'solid' ? SOLID_ALPHA : use === 'blended' ? SEEN_ALPHA : 0;
  function sync(): void {
    // Materials that lack one of these, such as lines, have no such holes.
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

/** Whether a material covers what is behind it and writes no depth. What only adds light covers nothing. */
export function blendsWithoutDepth({ transparent, depthWrite, blending }: Material): boolean {
  return transparent && !depthWrite && blending === NormalBlending;
}
