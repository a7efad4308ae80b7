import {
  BackSide,
  Color,
  CustomBlending,
  DoubleSide,
  FrontSide,
  type IUniform,
  type Material,
  Matrix3,
  type MeshStandardMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  type Side,
  type Texture,
  UniformsLib,
  UniformsUtils,
  Vector4,
} from 'three';
import type { TechniqueView } from '../../../../nodes/kit/technique-view.ts';
import type { EdgeGeometry } from './edges/edge-geometry.ts';
import { techniqueEdges } from './edges/edge-wrapper.ts';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { createShadowOffsetPatch } from './shadow-offset-patch.ts';
import { techniqueFragment, techniqueVertex } from './technique-wrapper.ts';
import type { TranslucentShadowPatch } from './translucent-shadow-patch.ts';
import type { Twin } from './twins.ts';

export interface TechniqueTwinOptions {
  readonly technique: TechniqueView;
  readonly passIndex: number;
  /** The edges to draw instead of triangles, in passes of edges. */
  readonly edges: EdgeGeometry | null;
  /** Whether it draws only depth, before the colors and a little behind them. */
  readonly depthOnly: boolean;
  /** Uniforms that materials share: of the technique and of the view. */
  readonly shared: Readonly<Record<string, IUniform>>;
  /** GLSL of the function `BEHIND`; empty where the page has no glass. */
  readonly behind: string;
  readonly occlusion: ShaderPatch | null;
  readonly translucentShadows: TranslucentShadowPatch;
  /** Called when the master needs to be drawn differently, such as after it became transparent. */
  readonly onChange: () => void;
}

const SIDES = { front: FrontSide, back: BackSide, both: DoubleSide } as const;

/** The properties that techniques copy from a master; some materials lack some of them. */
type Master = Material & Partial<Pick<MeshStandardMaterial, 'color' | 'map' | 'flatShading'>>;

/**
 * Creates a material that draws one pass of a technique instead of the master. Output is premultiplied and encoded as that of other twins.
 */
export function createTechniqueTwin(master: Master, options: TechniqueTwinOptions): Twin {
  const { technique, passIndex, edges, depthOnly, shared, behind, occlusion, translucentShadows, onChange } = options;
  const color = new Vector4();
  const map: IUniform<Texture | null> = { value: null };
  const mapTransform = new Matrix3();
  const material = new ShaderMaterial({
    name: `technique ${technique.key}`,
    vertexShader: (edges ? techniqueEdges : techniqueVertex)(technique.vertex, technique.fragment, passIndex),
    fragmentShader: techniqueFragment(technique.fragment, passIndex, behind),
    lights: true,
    uniforms: {
      ...UniformsUtils.clone(UniformsLib.lights),
      ...shared,
      ...edges?.uniforms,
      scrimColor: { value: color },
      alphaTest: { value: 0 },
      map,
      mapTransform: { value: mapTransform },
    },
  });
  // Both stages write premultiplied color, and surfaces that fade at a soft border of the room are blended even if opaque.
  material.defines = { PREMULTIPLIED_OUTPUT: '' };
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  material.forceSinglePass = true;
  material.colorWrite = !depthOnly;
  material.polygonOffset = depthOnly;
  material.polygonOffsetFactor = 1;
  material.polygonOffsetUnits = 1;
  const patches = [createShadowOffsetPatch(), translucentShadows];
  patchMaterial(material, null, occlusion ? [...patches, occlusion] : patches);
  translucentShadows.attach(material);
  const side = technique.passes[passIndex]?.side ?? 'object';
  let version = master.version;

  /** Updates the properties for which three.js recompiles the material. */
  function follow(): void {
    if (edges) {
      followEdges();
      return;
    }
    if (master.transparent) delete material.defines.OPAQUE;
    else material.defines.OPAQUE = '';
    Object.assign(material, { map: master.map ?? null, flatShading: master.flatShading ?? false });
    material.vertexColors = master.vertexColors;
    material.alphaTest = master.alphaTest;
    material.transparent = master.transparent && !depthOnly;
    material.needsUpdate = true;
  }

  /** Edges have no texture coordinates and no vertex colors; their quads face the camera, so the side of the master decides in the shader. */
  function followEdges(): void {
    material.defines.SCRIM_EDGES = '';
    material.defines.SCRIM_FACING = master.side === BackSide ? '- 1.0' : '1.0';
    if (master.side === DoubleSide) material.defines.SCRIM_TWO_SIDED = '';
    else delete material.defines.SCRIM_TWO_SIDED;
    material.transparent = master.transparent;
    material.needsUpdate = true;
  }

  function sync(): void {
    if (master.version !== version) {
      version = master.version;
      follow();
      onChange();
    }
    material.visible = master.visible;
    material.side = sideOf(side, master.side);
    material.depthWrite = master.depthWrite;
    material.depthTest = master.depthTest;
    const { r, g, b } = master.color ?? WHITE;
    color.set(r, g, b, master.opacity);
    const alphaTest = material.uniforms.alphaTest;
    if (alphaTest) alphaTest.value = edges ? 0 : master.alphaTest;
    map.value = edges ? null : (master.map ?? null);
    if (master.map) {
      if (master.map.matrixAutoUpdate) master.map.updateMatrix();
      mapTransform.copy(master.map.matrix);
    }
  }
  follow();
  sync();
  return {
    material,
    sync,
    dispose: () => {
      translucentShadows.detach(material);
      material.dispose();
    },
  };
}

const WHITE = new Color(1, 1, 1);

/** The side that a pass draws. For a master that shows only back faces, `back` means its front faces. */
function sideOf(pass: TechniqueView['passes'][number]['side'], own: Side): Side {
  if (pass === 'object') return own;
  if (pass === 'edges') return DoubleSide;
  return own === BackSide && pass === 'back' ? FrontSide : SIDES[pass];
}
