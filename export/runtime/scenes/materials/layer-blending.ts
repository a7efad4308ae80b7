import {
  AddEquation,
  AdditiveBlending,
  CustomBlending,
  type Material,
  type MeshPhysicalMaterial,
  NormalBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SrcAlphaFactor,
  ZeroFactor,
} from 'three';

export function isTransmissive(material: Material): material is MeshPhysicalMaterial {
  return ((material as Partial<MeshPhysicalMaterial>).transmission ?? 0) > 0;
}

/** Whether three.js draws the material with alpha 1 and without blending. */
export function isOpaque(material: Material): boolean {
  return !material.transparent && material.blending === NormalBlending && !material.alphaToCoverage && !isTransmissive(material);
}

/**
 * Sets blending and defines of a twin so that a layer over transparent black is premultiplied (docs/ARCHITECTURE.md, “Drawing”).
 *
 * - Opaque and normal blending: as in three.js, whose factors give color × alpha and the right alpha.
 * - Additive: three.js also adds the alpha, which would cover the background; added light covers nothing.
 * - Glass, and opaque surfaces that `occlusion-patch.ts` fades: their shaders write premultiplied color. Glass contains what is visible
 *   through it, so it often replaces what is drawn (`glass-scene.ts`).
 */
export function applyLayerBlending(twin: Material, master: Material, fades: boolean): void {
  twin.defines = { ...master.defines };
  if (isTransmissive(master) || (isOpaque(master) && fades)) {
    // With another blending than normal, three.js does not ignore the alpha of textures by itself.
    if (!master.transparent) twin.defines.OPAQUE = '';
    twin.defines.PREMULTIPLIED_OUTPUT = '';
    setBlending(twin, OneFactor, OneMinusSrcAlphaFactor, OneFactor, OneMinusSrcAlphaFactor);
  } else if (master.blending === AdditiveBlending) {
    setBlending(twin, master.premultipliedAlpha ? OneFactor : SrcAlphaFactor, OneFactor, ZeroFactor, OneFactor);
  } else {
    twin.blending = master.blending;
    twin.blendSrc = master.blendSrc;
    twin.blendDst = master.blendDst;
    twin.blendEquation = master.blendEquation;
    twin.blendSrcAlpha = master.blendSrcAlpha;
    twin.blendDstAlpha = master.blendDstAlpha;
    twin.blendEquationAlpha = master.blendEquationAlpha;
  }
  if (master.premultipliedAlpha) twin.defines.PREMULTIPLIED_OUTPUT = '';
}

type Factor = typeof OneFactor | typeof OneMinusSrcAlphaFactor | typeof SrcAlphaFactor;

function setBlending(material: Material, src: Factor, dst: Factor, srcAlpha: Factor | typeof ZeroFactor, dstAlpha: Factor): void {
  material.blending = CustomBlending;
  material.blendEquation = AddEquation;
  material.blendEquationAlpha = AddEquation;
  material.blendSrc = src;
  material.blendDst = dst;
  material.blendSrcAlpha = srcAlpha;
  material.blendDstAlpha = dstAlpha;
}
