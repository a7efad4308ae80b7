/** What the node sends to its worker: the positions once, then directions of view with the buffer for the order. */
export type SortTask =
  | { readonly kind: 'positions'; readonly positions: Float32Array<ArrayBuffer> }
  | { readonly kind: 'sort'; readonly direction: Float32Array; order: Uint32Array<ArrayBuffer> };

/** The order for the last direction, the farthest splat first. */
export interface SortAnswer {
  readonly order: Uint32Array<ArrayBuffer>;
}
