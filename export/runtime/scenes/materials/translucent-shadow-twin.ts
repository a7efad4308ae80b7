import {
  AddEquation,
  BasicDepthPacking,
  CustomBlending,
  type Material,
  MeshDepthMaterial,
  type MeshPhysicalMaterial,
  MinEquation,
  OneFactor,
  SrcColorFactor,
  ZeroFactor,
} from 'three';
import { isTransmissive } from './layer-blending.ts';
import { patchMaterial, type ShaderPatch, wrapMain } from './shader-patch.ts';
import { setMap, type Twin } from './twins.ts';

/**
 * How a master blocks light: `part`, the fraction blocked where alpha is 1, and `blends`, whether alpha reduces it or serves only the alpha
 * test.
 */
interface Solid {
  readonly part: { value: number };
  readonly blends: { value: boolean };
}

/**
 * Creates a patch that writes, instead of depth, the fraction of light that passes and the distance of the caster, meters along the light's
 * axis.
 */
function createThrough({ part, blends }: Solid): ShaderPatch {
  return {
    key: 'translucent',
    apply: (shader) => {
      Object.assign(shader.uniforms, { solidPart: part, alphaBlends: blends });
      shader.vertexShader = wrapMain(shader.vertexShader, {
        before: 'varying float vMeters;',
        start: '',
        end: 'vMeters = - mvPosition.z;',
      });
      shader.fragmentShader = wrapMain(shader.fragmentShader, {
        before: 'varying float vMeters;\nuniform float solidPart;\nuniform bool alphaBlends;',
        start: '',
        end: `float solid = solidPart * ( alphaBlends ? clamp( diffuseColor.a, 0.0, 1.0 ) : 1.0 );
  gl_FragColor = vec4( vec3( 1.0 - solid ), vMeters );`,
      });
    },
  };
}

/**
 * Creates a material that draws a transparent caster as seen from a light, over white. After all casters, red is the fraction of light that
 * passes them, and alpha the distance of the nearest. Sides are those of the master, so that a closed body dims once.
 */
export function createTranslucentShadowTwin(master: Material): Twin {
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
  const solid: Solid = { part: { value: 1 }, blends: { value: true } };
  patchMaterial(material, null, [createThrough(solid)]);
  function sync(): void {
    const from = master as Partial<MeshPhysicalMaterial> & Material;
    solid.part.value = 1 - (from.transmission ?? 0);
    solid.blends.value = from.transparent;
    material.visible = from.visible && castsTranslucentShadow(master);
    material.side = from.shadowSide ?? from.side;
    material.wireframe = from.wireframe ?? false;
    material.opacity = from.opacity;
    material.alphaTest = from.alphaTest;
    material.displacementScale = from.displacementScale ?? 1;
    material.displacementBias = from.displacementBias ?? 0;
    setMap(material, 'map', from.map);
    setMap(material, 'alphaMap', from.alphaMap);
    setMap(material, 'displacementMap', from.displacementMap);
  }
  sync();
  return { material, sync, dispose: () => material.dispose() };
}

/** Whether a material dims light instead of blocking it: transparent materials and glass. */
export function castsTranslucentShadow(master: Material): boolean {
  return master.transparent || isTransmissive(master);
}
