import { BasicDepthPacking, DoubleSide, type Material, MeshDepthMaterial, type MeshStandardMaterial, type Texture } from 'three';
import type { Twin } from './twins.ts';
import { castsVeil } from './veil-twin.ts';

/** Below this, a surface that is blended lets light through rather than stopping it. */
const SOLID_ALPHA = 0.5;

/**
 * Draws the master's shape into depth alone: holes cut by its alpha test, moved by its displacement map.
 *
 * - `surface`: for what stands for a real thing or is drawn again in its colours. It lies a little behind the surface itself, so
 *   that what lies on the surface wins over it.
 * - `shadow`: both sides, because a single-sided wall casts a shadow whichever way it faces; what is see-through dims the light instead
 *   (`veil-twin.ts`).
 * - `solid`: as `surface`, but what is blended is there where its alpha is above one half.
 */
export function createDepthTwin(master: Material, use: 'surface' | 'shadow' | 'solid'): Twin {
  const material = new MeshDepthMaterial();
  // In a shadow map, some filters read what it writes: 1 less the depth.
  material.depthPacking = BasicDepthPacking;
  material.colorWrite = use === 'shadow';
  material.polygonOffset = use !== 'shadow';
  material.polygonOffsetFactor = 1;
  material.polygonOffsetUnits = 1;
  function sync(): void {
    // Materials that lack one of these, such as lines, have no such holes.
    const from = master as Partial<MeshStandardMaterial> & Material;
    const alphaTest = from.alphaTest > 0 ? from.alphaTest : use === 'solid' && from.transparent ? SOLID_ALPHA : 0;
    material.visible = from.visible && !(use === 'shadow' && castsVeil(master));
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

function setMap(material: MeshDepthMaterial, name: 'map' | 'alphaMap' | 'displacementMap', texture: Texture | null | undefined): void {
  const next = texture ?? null;
  // With or without a map are two programs.
  if ((material[name] === null) !== (next === null)) material.needsUpdate = true;
  material[name] = next;
}
