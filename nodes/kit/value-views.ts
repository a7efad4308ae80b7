/** A live value: read it every frame. */
export interface NumberView {
  readonly value: number;
}
export interface ToggleView {
  readonly value: boolean;
}
export interface TextView {
  readonly value: string;
}
/** Components of a vector or color; the same array every frame. */
export interface VectorView {
  readonly value: Readonly<Float64Array>;
}

export type Writable<T> = { -readonly [K in keyof T]: T[K] };

export interface ValueViews {
  number: NumberView;
  vector2: VectorView;
  vector3: VectorView;
  vector4: VectorView;
  color: VectorView;
  toggle: ToggleView;
  text: TextView;
}
