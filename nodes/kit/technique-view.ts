import type { NumberView, ToggleView, VectorView } from './value-views.ts';

/** A custom material on an object. If several match a material, the last one applies. */
export interface AppliedTechnique {
  readonly technique: TechniqueView;
  /** Names of the materials that it replaces; null for all. */
  readonly materials: readonly string[] | null;
}

/** A technique of the running program. */
export interface TechniqueView {
  /** Increased when its text or passes change: rebuild what is derived from them. */
  readonly version: number;
  /** Unique among all techniques for this text. */
  readonly key: string;
  /** GLSL for a shader that provides the interface of `export/glsl/technique/interface.ts`. */
  readonly vertex: string;
  /** Likewise, for the fragment shader. */
  readonly fragment: string;
  /** The passes of each object, in order; `object`: the sides that its own material shows. */
  readonly passes: readonly { readonly side: 'object' | 'front' | 'back' | 'both' }[];
  /** Live values: read them every frame. Colors are display-referred sRGB, as in params. */
  readonly uniforms: readonly TechniqueUniformView[];
  /** The layers and images that its text reads, by the name of their uniform. */
  readonly images: readonly TechniqueImageView[];
}

/** An image input of a technique. */
export interface TechniqueImageView {
  readonly name: string;
  /**
   * The image for a view, valid until the next call. Its pixels are available while the objects are drawn, not before.
   *
   * @param viewWidthPx Width of the view; `viewHeightPx` is its height.
   */
  at(viewIndex: number, viewWidthPx: number, viewHeightPx: number): TechniqueImage;
}

/** A texture with its transform. */
export interface TechniqueImage {
  /** Null: transparent. */
  readonly texture: WebGLTexture | null;
  /** Column-major 3×3: texture UV from view UV, for layers. */
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
