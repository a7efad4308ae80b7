import {
  ClampToEdgeWrapping,
  EquirectangularReflectionMapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  SRGBColorSpace,
  Texture,
} from 'three';
import type { LoadedEnvironment } from '../../scene-backend.ts';
import { ownPixels } from './filled-texture.ts';
import { PanoramaError, type RadianceHeader, readRadianceHeader } from './radiance-header.ts';
import type { ReadRadiance } from './read-radiance.ts';

/** At 4096 rows, 16-bit floats with mipmaps take 350 MB. */
const MAX_WIDTH_PX = 8192;

/**
 * Decodes an equirectangular image: Radiance HDR and OpenEXR as linear 16-bit floats, other formats as display-referred sRGB with white at
 * 1. An image above the size limit is reduced.
 *
 * @throws PanoramaError, as a rejection, if the file is invalid.
 */
export async function loadPanorama(bytes: ArrayBuffer, maxTexturePx: number, readRadiance: ReadRadiance): Promise<LoadedPanorama> {
  const maxPx = Math.min(MAX_WIDTH_PX, maxTexturePx);
  const header = readRadianceHeader(bytes);
  if (header) checkSize(header, maxPx);
  const texture = header ? readRadiance.halves(bytes, header) : await readPicture(bytes, maxPx);
  const readPixels = () => (header ? readRadiance.floats(bytes, header) : ownPixels(texture));
  return panoramaOf(texture, readPixels);
}

/** A panorama that is not filtered for lighting yet. */
export type LoadedPanorama = Omit<LoadedEnvironment, 'withoutLamps' | 'lamps' | 'findLamps'>;

/** Sets a texture up as a panorama, which owns it. */
export function panoramaOf(texture: Texture, readPixels: LoadedPanorama['readPixels']): LoadedPanorama {
  texture.mapping = EquirectangularReflectionMapping;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = ClampToEdgeWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  const { width: widthPx, height: heightPx } = texture.image as { width: number; height: number };
  return { texture, widthPx, heightPx, readPixels, dispose: () => disposeTexture(texture) };
}

function checkSize({ widthPx, heightPx }: RadianceHeader, maxPx: number): void {
  if (widthPx < 1 || heightPx < 1) throw new PanoramaError('it has no pixels. Export it again');
  if (widthPx > maxPx || heightPx > maxPx) {
    throw new PanoramaError(
      `it has ${widthPx} × ${heightPx} pixels, and at most ${maxPx} a side can be shown. 4096 × 2048 is sharp enough for a sky`,
    );
  }
}

async function readPicture(bytes: ArrayBuffer, maxPx: number): Promise<Texture> {
  const options: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none', imageOrientation: 'flipY' };
  const full = await createImageBitmap(new Blob([bytes]), options).catch(() => {
    throw new PanoramaError('it is no picture. Use a Radiance HDR (.hdr), OpenEXR (.exr), JPEG, PNG or WebP file');
  });
  const scale = maxPx / Math.max(full.width, full.height);
  const texture = new Texture(scale >= 1 ? full : await shrink(full, scale));
  texture.colorSpace = SRGBColorSpace;
  texture.flipY = false;
  return texture;
}

async function shrink(full: ImageBitmap, scale: number): Promise<ImageBitmap> {
  const smaller = await createImageBitmap(full, {
    premultiplyAlpha: 'none',
    resizeWidth: Math.max(1, Math.floor(full.width * scale)),
    resizeHeight: Math.max(1, Math.floor(full.height * scale)),
    resizeQuality: 'high',
  });
  full.close();
  return smaller;
}

function disposeTexture(texture: Texture): void {
  texture.dispose();
  if (texture.image instanceof ImageBitmap) texture.image.close();
}
