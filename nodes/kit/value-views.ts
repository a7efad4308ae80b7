/** A live number: read it every frame. */
export interface NumberView {
  readonly value: number;
}

/** A live toggle: read it every frame. */
export interface ToggleView {
  readonly value: boolean;
}

/** A live text: read it every frame. */
export interface TextView {
  readonly value: string;
}

/** The components of a live vector or color: the same array every frame. Colors are display-referred sRGB with straight alpha. */
export interface VectorView {
  readonly value: Readonly<Float64Array>;
}

/** A type with its properties made writable. Runtimes write the values of their outputs through it. */
export type Writable<T> = { -readonly [K in keyof T]: T[K] };

/** The view of each value type. */
export interface ValueViews {
  number: NumberView;
  vector2: VectorView;
  vector3: VectorView;
  vector4: VectorView;
  color: VectorView;
  toggle: ToggleView;
  text: TextView;
}
