import type { NumberView, ToggleView, VectorView } from './value-views.ts';

/** A custom material on an object. If several match a material, the last one applies. */
export interface AppliedTechnique {
  readonly technique: TechniqueView;
  /** Names of the materials that the technique replaces; null for all. */
  readonly materials: readonly string[] | null;
}

/** A technique of the running program. */
export interface TechniqueView {
  /** A number that is increased when the text or the passes of the technique change: rebuild what is derived from them. */
  readonly version: number;
  /** A key for the text of the technique: techniques with different texts have different keys. */
  readonly key: string;
  /** GLSL to include in a vertex shader that provides the interface of `export/glsl/technique/interface.ts`. */
  readonly vertex: string;
  /** GLSL to include in a fragment shader that provides the interface of `export/glsl/technique/interface.ts`. */
  readonly fragment: string;
  /**
   * The passes in which each object is drawn, in order, with the sides of its surface that a pass shows. `object`: those that its own
   * material shows. `edges` draws edges as lines; an `open` pass only those of meshes with a border.
   */
  readonly passes: readonly { readonly side: 'object' | 'front' | 'back' | 'both' | 'edges'; readonly open?: true }[];
  /** The uniforms with their live values: read them every frame. Colors are display-referred sRGB, as in params. */
  readonly uniforms: readonly TechniqueUniformView[];
  /**
   * When the technique does not read `s.along`, the direction field of a mesh, or `s.radial`, its curvature: while the uniform has one of the
   * values. They take long to compute.
   */
  readonly unread?: readonly { readonly name: 'along' | 'radial'; readonly uniform: string; readonly values: readonly number[] }[];
  /** The layers and images that the technique reads, by the name of their uniform. */
  readonly images: readonly TechniqueImageView[];
}

/** An image input of a technique. */
export interface TechniqueImageView {
  readonly name: string;
  /**
   * Returns the image for a view, valid until the next call. Its pixels are available while the objects are drawn, not before.
   *
   * @param viewWidthPx Width of the view; `viewHeightPx` is its height.
   */
  at(viewIndex: number, viewWidthPx: number, viewHeightPx: number): TechniqueImage;
}

/** An image as a technique samples it: a texture and its UV matrix. */
export interface TechniqueImage {
  /** The texture; null: the image is transparent. */
  readonly texture: WebGLTexture | null;
  /** The matrix from view UV to texture UV, column-major 3×3. Only for layers. */
  readonly uvFromViewUv: Readonly<Float32Array>;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A uniform of a technique, with its live value. */
export type TechniqueUniformView = { readonly name: string } & (
  | { readonly kind: 'number'; readonly view: NumberView }
  | { readonly kind: 'toggle'; readonly view: ToggleView }
  | { readonly kind: 'vector'; readonly view: VectorView }
  | { readonly kind: 'color'; readonly view: VectorView }
);
