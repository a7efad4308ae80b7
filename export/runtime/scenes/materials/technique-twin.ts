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
  SRGBColorSpace,
  type Texture,
  UniformsLib,
  UniformsUtils,
  Vector2,
  type Vector3,
  Vector4,
} from 'three';
import type { TechniqueUniformView, TechniqueView } from '../../../../nodes/kit/technique-view.ts';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { techniqueFragment, techniqueVertex } from './technique-wrapper.ts';
import type { Twin } from './twins.ts';

export interface TechniqueTwinOptions {
  readonly technique: TechniqueView;
  readonly passIndex: number;
  /** Depth alone, before the colours; a little behind them. */
  readonly depthOnly: boolean;
  /** Brightness of the surroundings; shared by all techniques of a scene. */
  readonly ambient: IUniform<Vector3>;
  readonly occlusion: ShaderPatch | null;
  /** Called when the master began to need another way of drawing, such as having become transparent. */
  readonly onChange: () => void;
}

// Read by the call that fills it, before anything else can.
const scratchColor = new Color();

const SIDES = { front: FrontSide, back: BackSide, both: DoubleSide } as const;

/** What techniques follow of a master: its colour and what cuts it out. Materials of other kinds lack some of it. */
type Master = Material & Partial<Pick<MeshStandardMaterial, 'color' | 'map' | 'flatShading'>>;

/** One pass of a technique in the place of the master. Its output is premultiplied and encoded as other twins' are. */
export function createTechniqueTwin(master: Master, options: TechniqueTwinOptions): Twin {
  const { technique, passIndex, depthOnly, ambient, occlusion, onChange } = options;
  const values = technique.uniforms.map(bindUniform);
  const color = new Vector4();
  const map: IUniform<Texture | null> = { value: null };
  const mapTransform = new Matrix3();
  const material = new ShaderMaterial({
    name: `technique ${technique.key}`,
    vertexShader: techniqueVertex(technique.vertex, passIndex),
    fragmentShader: techniqueFragment(technique.fragment, passIndex),
    lights: true,
    uniforms: {
      ...UniformsUtils.clone(UniformsLib.lights),
      ...Object.fromEntries(values.map(({ name, uniform }) => [name, uniform])),
      scrimAmbient: ambient,
      scrimColor: { value: color },
      alphaTest: { value: 0 },
      map,
      mapTransform: { value: mapTransform },
    },
  });
  // Both stages write premultiplied colour, and what fades at a soft border of the room is blended, opaque or not.
  material.defines = { PREMULTIPLIED_OUTPUT: '' };
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  material.forceSinglePass = true;
  material.colorWrite = !depthOnly;
  material.polygonOffset = depthOnly;
  material.polygonOffsetFactor = 1;
  material.polygonOffsetUnits = 1;
  patchMaterial(material, null, occlusion ? [occlusion] : []);
  const side = technique.passes[passIndex]?.side ?? 'object';
  let version = master.version;

  /** What three compiles by. */
  function follow(): void {
    if (master.transparent) delete material.defines.OPAQUE;
    else material.defines.OPAQUE = '';
    Object.assign(material, { map: master.map ?? null, flatShading: master.flatShading ?? false });
    material.vertexColors = master.vertexColors;
    material.alphaTest = master.alphaTest;
    material.transparent = master.transparent && !depthOnly;
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
    if (alphaTest) alphaTest.value = master.alphaTest;
    map.value = master.map ?? null;
    if (master.map) {
      if (master.map.matrixAutoUpdate) master.map.updateMatrix();
      mapTransform.copy(master.map.matrix);
    }
    for (const value of values) value.update();
  }
  follow();
  sync();
  return { material, sync, dispose: () => material.dispose() };
}

const WHITE = new Color(1, 1, 1);

/** `back` of what shows its back faces alone is its front. */
function sideOf(pass: TechniqueView['passes'][number]['side'], own: Side): Side {
  if (pass === 'object') return own;
  return own === BackSide && pass === 'back' ? FrontSide : SIDES[pass];
}

interface BoundUniform {
  readonly name: string;
  readonly uniform: IUniform;
  /** Takes over the live value. */
  update(): void;
}

/** Colours are linearised: techniques shade in linear light. */
function bindUniform(source: TechniqueUniformView): BoundUniform {
  const { name } = source;
  switch (source.kind) {
    case 'number': {
      const uniform = { value: 0 };
      return { name, uniform, update: () => (uniform.value = source.view.value) };
    }
    case 'toggle': {
      const uniform = { value: false };
      return { name, uniform, update: () => (uniform.value = source.view.value) };
    }
    case 'vector': {
      const value = new Vector2();
      return { name, uniform: { value }, update: () => value.fromArray(source.view.value) };
    }
    case 'color': {
      const value = new Vector4();
      return { name, uniform: { value }, update: () => setLinear(value, source.view.value) };
    }
  }
}

function setLinear(into: Vector4, srgb: Readonly<Float64Array>): void {
  const { r, g, b } = scratchColor.setRGB(srgb[0] ?? 0, srgb[1] ?? 0, srgb[2] ?? 0, SRGBColorSpace);
  into.set(r, g, b, srgb[3] ?? 1);
}
