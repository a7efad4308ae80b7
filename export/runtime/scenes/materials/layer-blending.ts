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

export function isTransmissive(material: Material): boolean {
  return ((material as Partial<MeshPhysicalMaterial>).transmission ?? 0) > 0;
}

/** Whether three draws the material with alpha 1 and without blending. */
export function isOpaque(material: Material): boolean {
  return !material.transparent && material.blending === NormalBlending && !material.alphaToCoverage && !isTransmissive(material);
}

/**
 * Sets the twin's blending and defines so that a layer over transparent black comes out premultiplied (docs/ARCHITECTURE.md, “Drawing”).
 *
 * - Opaque, normally blended: as three has them. Its factors for normal blending give color × alpha and the right alpha.
 * - Additive: three also adds the alpha, which would cover what lies behind the layer; light that is only added covers nothing.
 * - Glass, and opaque surfaces that `occlusion-patch.ts` fades: their shaders write premultiplied color, blended over.
 */
export function applyLayerBlending(twin: Material, master: Material, fades: boolean): void {
  twin.defines = { ...master.defines };
  if (!master.transparent && (isTransmissive(master) || (isOpaque(master) && fades))) {
    // Another blending than three's normal one keeps it from ignoring the texture's alpha by itself.
    twin.defines.OPAQUE = '';
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
