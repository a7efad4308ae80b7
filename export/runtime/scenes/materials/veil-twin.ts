import {
  AddEquation,
  BasicDepthPacking,
  CustomBlending,
  type Material,
  MeshDepthMaterial,
  type MeshStandardMaterial,
  MinEquation,
  OneFactor,
  SrcColorFactor,
  ZeroFactor,
} from 'three';
import { patchMaterial, type ShaderPatch, wrapMain } from './shader-patch.ts';
import type { Twin } from './twins.ts';

/** Instead of the depth that three writes: what comes through, and how far away it is that dims. */
const THROUGH: ShaderPatch = {
  key: 'veil',
  apply: (shader) => {
    shader.fragmentShader = wrapMain(shader.fragmentShader, {
      before: '',
      start: '',
      end: 'gl_FragColor = vec4( vec3( 1.0 - clamp( diffuseColor.a, 0.0, 1.0 ) ), fragCoordZ );',
    });
  },
};

/**
 * Draws what is blended as a light sees it, over white: red is what is left of the light after all of it, alpha the depth of the
 * nearest. Sides are the master's own, so that a closed body dims once.
 */
export function createVeilTwin(master: Material): Twin {
  const material = new MeshDepthMaterial();
  material.depthPacking = BasicDepthPacking;
  material.transparent = true;
  material.depthTest = false;
  material.depthWrite = false;
  material.blending = CustomBlending;
  material.blendEquation = AddEquation;
  material.blendSrc = ZeroFactor;
  material.blendDst = SrcColorFactor;
  material.blendEquationAlpha = MinEquation;
  material.blendSrcAlpha = OneFactor;
  material.blendDstAlpha = OneFactor;
  patchMaterial(material, null, [THROUGH]);
  function sync(): void {
    const from = master as Partial<MeshStandardMaterial> & Material;
    material.visible = from.visible && castsVeil(master);
    material.side = from.shadowSide ?? from.side;
    material.wireframe = from.wireframe ?? false;
    material.opacity = from.opacity;
    material.alphaTest = from.alphaTest;
    material.displacementScale = from.displacementScale ?? 1;
    material.displacementBias = from.displacementBias ?? 0;
    for (const name of ['map', 'alphaMap', 'displacementMap'] as const) {
      const next = from[name] ?? null;
      // With or without a map are two programs.
      if ((material[name] === null) !== (next === null)) material.needsUpdate = true;
      material[name] = next;
    }
  }
  sync();
  return { material, sync, dispose: () => material.dispose() };
}

/** Whether it dims the light, rather than stopping it. */
export function castsVeil(master: Material): boolean {
  return master.transparent;
}
