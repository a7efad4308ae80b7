import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, RGBAFormat, SRGBColorSpace, UnsignedByteType } from 'three';
import type { SurfaceStyle } from './surfaces.ts';

export interface PaintedTexture {
  readonly texture: DataTexture;
  /** Linear-sRGB, for light that the surface reflects. */
  readonly meanAlbedo: readonly [number, number, number];
}

/** Generates the texture of a surface on the CPU. */
export function paintTexture({ paint, sizePx: [width, height] }: SurfaceStyle): PaintedTexture {
  const rgba = new Uint8Array(width * height * 4);
  const mean: [number, number, number] = [0, 0, 0];
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const color = paint((column + 0.5) / width, (row + 0.5) / height);
      const at = (row * width + column) * 4;
      for (let c = 0; c < 3; c++) {
        const value = Math.min(Math.max(color[c] ?? 0, 0), 1);
        rgba[at + c] = Math.round(value * 255);
        // A gamma of 2.2 approximates the sRGB curve well enough for a mean.
        mean[c] = (mean[c] ?? 0) + value ** 2.2 / (width * height);
      }
      rgba[at + 3] = 255;
    }
  }
  const texture = new DataTexture(rgba, width, height, RGBAFormat, UnsignedByteType);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return { texture, meanAlbedo: mean };
}
