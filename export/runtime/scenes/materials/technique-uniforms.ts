import { Color, ExternalTexture, type IUniform, Matrix3, SRGBColorSpace, Vector2, Vector4 } from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { TechniqueImageView, TechniqueUniformView, TechniqueView } from '../../../../nodes/kit/technique-view.ts';

/** Values and images of one technique, shared by all of its materials in a scene. */
export interface TechniqueUniforms {
  readonly uniforms: Readonly<Record<string, IUniform>>;
  /** Applies this frame's values. */
  update(): void;
  /** Applies the view's images; called before every draw. */
  bind(view: DrawView): void;
}

// Valid within one call.
const scratchColor = new Color();

/**
 * A UV matrix that maps all points outside of the image, where it is transparent. Used for layers without a texture, because an unbound
 * texture would be black.
 */
const NOWHERE = Float32Array.of(0, 0, 0, 0, 0, 0, 9, 9, 1);

export function createTechniqueUniforms(technique: TechniqueView): TechniqueUniforms {
  const uniforms: Record<string, IUniform> = { a_TIME: { value: 0 } };
  for (const { name, kind } of technique.uniforms) uniforms[name] = { value: emptyValue(kind) };
  for (const { name } of technique.images) {
    uniforms[name] = { value: new ExternalTexture() };
    uniforms[`${name}_uvFromViewUv`] = { value: new Matrix3() };
    uniforms[`${name}_size`] = { value: new Vector2() };
  }
  return {
    uniforms,
    // The lists are replaced after a recompile, with the same names.
    update: () => {
      for (let i = 0; i < technique.uniforms.length; i++) {
        const source = technique.uniforms[i];
        const uniform = source && uniforms[source.name];
        if (uniform) setValue(uniform, source);
      }
    },
    bind: ({ viewIndex, viewport }) => {
      for (let i = 0; i < technique.images.length; i++) {
        const image = technique.images[i];
        if (image) bindImage(uniforms, image, viewIndex, viewport);
      }
    },
  };
}

function emptyValue(kind: TechniqueUniformView['kind']): unknown {
  switch (kind) {
    case 'number':
      return 0;
    case 'toggle':
      return false;
    case 'vector':
      return new Vector2();
    case 'color':
      return new Vector4();
  }
}

/** Sets a uniform to its current value. Colors are converted to linear, because techniques shade in linear light. */
function setValue(uniform: IUniform, source: TechniqueUniformView): void {
  switch (source.kind) {
    case 'number':
    case 'toggle':
      uniform.value = source.view.value;
      break;
    case 'vector':
      uniform.value.fromArray(source.view.value);
      break;
    case 'color':
      setLinear(uniform.value, source.view.value);
      break;
    default:
      source satisfies never;
  }
}

function setLinear(into: Vector4, srgb: Readonly<Float64Array>): void {
  const { r, g, b } = scratchColor.setRGB(srgb[0] ?? 0, srgb[1] ?? 0, srgb[2] ?? 0, SRGBColorSpace);
  into.set(r, g, b, srgb[3] ?? 1);
}

function bindImage(
  uniforms: Readonly<Record<string, IUniform>>,
  { name, at }: TechniqueImageView,
  viewIndex: number,
  { widthPx, heightPx }: DrawView['viewport'],
): void {
  const image = at(viewIndex, widthPx, heightPx);
  const texture = uniforms[name]?.value as ExternalTexture | undefined;
  if (texture) texture.sourceTexture = image.texture;
  uniforms[`${name}_uvFromViewUv`]?.value.fromArray(image.texture ? image.uvFromViewUv : NOWHERE);
  uniforms[`${name}_size`]?.value.set(image.widthPx, image.heightPx);
}
