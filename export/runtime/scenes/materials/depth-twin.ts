import { DoubleSide, type Material, MeshDepthMaterial, type MeshStandardMaterial, type Texture } from 'three';
import type { Twin } from './twins.ts';

/** Below this, a surface that is blended lets light and sight through rather than stopping them. */
const SOLID_ALPHA = 0.5;

/**
 * Draws the master's shape into depth alone, holes cut by its alpha test and moved by its displacement map. A blended master
 * counts as solid where its alpha is above one half.
 *
 * `sides`: the master's own, or both, as for shadows: a single-sided wall casts one whichever way it faces.
 */
export function createDepthTwin(master: Material, sides: 'own' | 'both'): Twin {
  const material = new MeshDepthMaterial();
  material.colorWrite = false;
  function sync(): void {
    // Materials that lack one of these, such as lines, have no such holes.
    const from = master as Partial<MeshStandardMaterial> & Material;
    const cut = from.alphaTest > 0 || from.transparent;
    material.visible = from.visible;
    material.side = sides === 'both' ? (from.shadowSide ?? DoubleSide) : from.side;
    material.wireframe = from.wireframe ?? false;
    material.opacity = from.opacity;
    material.alphaTest = from.alphaTest > 0 ? from.alphaTest : from.transparent ? SOLID_ALPHA : 0;
    material.displacementScale = from.displacementScale ?? 1;
    material.displacementBias = from.displacementBias ?? 0;
    setMap(material, 'map', cut ? from.map : null);
    setMap(material, 'alphaMap', cut ? from.alphaMap : null);
    setMap(material, 'displacementMap', from.displacementMap);
  }
  sync();
  return { material, sync, dispose: () => material.dispose() };
}

/** Depth alone, a little behind the surface itself, so that what lies on the surface wins over it. */
export function createPhantomTwin(master: Material): Twin {
  const twin = createDepthTwin(master, 'own');
  twin.material.polygonOffset = true;
  twin.material.polygonOffsetFactor = 1;
  twin.material.polygonOffsetUnits = 1;
  return twin;
}

function setMap(material: MeshDepthMaterial, name: 'map' | 'alphaMap' | 'displacementMap', texture: Texture | null | undefined): void {
  const next = texture ?? null;
  // With or without a map are two programs.
  if ((material[name] === null) !== (next === null)) material.needsUpdate = true;
  material[name] = next;
}
