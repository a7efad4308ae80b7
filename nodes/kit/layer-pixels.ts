/** The pixels of a layer on the CPU, for inputs with `pixels` (ADR 46). */
export interface PixelsView {
  /**
   * Returns the newest pixels: those of the previous frame while the clock is held, else those that the GPU has delivered last.
   *
   * @returns Null before the first ones.
   *
   * @example
   * const pixels = ctx.inputs.mask?.read();
   */
  read(): LayerPixels | null;
}

/** A reduced image of a layer: each pixel is the mean of its part of the layer. The object and the array are reused. */
export interface LayerPixels {
  /** Premultiplied display-referred sRGB, RGBA8, rows from the bottom. */
  readonly data: Readonly<Uint8Array>;
  readonly widthPx: number;
  readonly heightPx: number;
}
