import type { NumberView, ToggleView, VectorView } from './value-views.ts';

/** What an object is drawn with instead of its own materials; of several for one material, the last counts. */
export interface AppliedTechnique {
  readonly technique: TechniqueView;
  /** Names of the materials that it takes the place of; null for all. */
  readonly materials: readonly string[] | null;
}

/** A technique of the running program. */
export interface TechniqueView {
  /** Raised when its text or its passes change: rebuild what was made of them. */
  readonly version: number;
  /** Unique for this text among all techniques. */
  readonly key: string;
  /** Text for shaders that define what `export/glsl/technique/interface.ts` names. */
  readonly vertex: string;
  readonly fragment: string;
  /** Draws of each object, in order; `object`: the sides that its own material shows. */
  readonly passes: readonly { readonly side: 'object' | 'front' | 'back' | 'both' }[];
  /** Live values: read them every frame. Colors are display-referred, as in params. */
  readonly uniforms: readonly TechniqueUniformView[];
  /** Layers and pictures that its text reads, by the name of their uniform. */
  readonly images: readonly TechniqueImageView[];
}

export interface TechniqueImageView {
  readonly name: string;
  /** What a view reads; valid until the next call. Its pixels are there when the objects are drawn, not before. */
  at(viewIndex: number, viewWidthPx: number, viewHeightPx: number): TechniqueImage;
}

export interface TechniqueImage {
  /** Null where there is nothing: it reads as transparent. */
  readonly texture: WebGLTexture | null;
  /** Column-major 3×3: texture UV from view UV, for layers. */
  readonly uvFromViewUv: Readonly<Float32Array>;
  readonly widthPx: number;
  readonly heightPx: number;
}

export type TechniqueUniformView = { readonly name: string } & (
  | { readonly kind: 'number'; readonly view: NumberView }
  | { readonly kind: 'toggle'; readonly view: ToggleView }
  | { readonly kind: 'vector'; readonly view: VectorView }
  | { readonly kind: 'color'; readonly view: VectorView }
);
