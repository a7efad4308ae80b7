import type { Splats } from './splats/splats.ts';

/** Gaussian splats on the GPU, in the space of their file. */
export interface SplatAsset {
  readonly count: number;
  readonly degree: Splats['degree'];
  readonly antialiased: boolean;
  /** `SPLATS_PER_ROW` splats per row, two texels of RGBA32UI each: the words of `splat-packer.ts`. */
  readonly data: WebGLTexture;
  /** The same number of splats per row, one texel of RGBA32UI per degree each. Null at degree 0. */
  readonly harmonics: WebGLTexture | null;
  /** What the largest byte of a coefficient of degree 1, 2 and 3 stands for. */
  readonly ranges: Splats['ranges'];
  /** x, y, z of each splat. */
  readonly positions: Float32Array<ArrayBuffer>;
}
