import {
  ClampToEdgeWrapping,
  DataTexture,
  DataUtils,
  EquirectangularReflectionMapping,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearSRGBColorSpace,
  RedFormat,
  RepeatWrapping,
  RGBAFormat,
  SRGBColorSpace,
  Texture,
} from 'three';
import { layoutOf, type PanoramaLayout, wrongShape } from '../../../../nodes/kit/panorama/layouts.ts';
import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import { type PlainPixels, toEquirectangular } from '../../../../nodes/kit/panorama/to-equirectangular.ts';
import type { LoadedEnvironment, ModelFinding } from '../../scene-backend.ts';
import { bytesTexture, ownPixels } from './filled-texture.ts';
import { PanoramaError, type RadianceHeader, readRadianceHeader } from './radiance-header.ts';
import type { HalfPixels, ReadRadiance } from './read-radiance.ts';

/** Maximum width of a panorama. With 4096 rows, 16-bit floats with mip levels then take 350 MB. */
const MAX_WIDTH_PX = 8192;

/** Maximum width of a panorama that is converted from a mirror ball or the faces of a cube; the conversion takes half a second. */
const MOST_CONVERTED_PX = 2048;
/** Minimum width and height of a panorama; smaller images show no directions. */
const LEAST_PX = 2;

/**
 * Decodes an equirectangular image: Radiance HDR and OpenEXR as linear 16-bit floats, other formats as display-referred sRGB with white at
 * 1. An image above the size limit is reduced. Photos of a mirror ball and the faces of a cube, which are recognized by their aspect ratio,
 * are converted.
 *
 * @throws PanoramaError, as a rejection, if the file is invalid.
 */
export async function loadPanorama(bytes: ArrayBuffer, maxTexturePx: number, readRadiance: ReadRadiance): Promise<LoadedPanorama> {
  const maxPx = Math.min(MAX_WIDTH_PX, maxTexturePx);
  const header = readRadianceHeader(bytes);
  if (header) checkSize(header, maxPx);
  const picture = header ? null : await readPicture(bytes, maxPx);
  const [widthPx, heightPx] = header ? [header.widthPx, header.heightPx] : sizeOf(picture);
  if (widthPx < LEAST_PX || heightPx < LEAST_PX) {
    picture?.close();
    throw new PanoramaError(`it has only ${widthPx} × ${heightPx} pixels. Export it again with at least 64 × 32`);
  }
  const layout = layoutOf(widthPx, heightPx);
  const findings = findingsOf(layout, widthPx, heightPx);
  if (layout !== null && layout !== 'equirectangular') {
    return { ...(header ? await convertRadiance(bytes, header, layout, readRadiance) : convertPicture(picture, layout)), findings };
  }
  const texture = header ? radianceTexture(await readRadiance.halves(bytes, header)) : pictureTexture(picture);
  const readPixels = () => (header ? readRadiance.floats(bytes, header) : ownPixels(texture));
  return { ...panoramaOf(texture, readPixels), findings };
}

function findingsOf(layout: PanoramaLayout | null, widthPx: number, heightPx: number): ModelFinding[] {
  if (layout === null) {
    const message = `The panorama is stretched. ${wrongShape(widthPx, heightPx)}`;
    return [{ code: 'SCR039', severity: 'warning', message, fix: 'Change the picture, or choose another one.' }];
  }
  if (layout !== 'ball') return [];
  const message = 'The panorama is square, so it is read as the photo of a mirror ball, cut to the ball.';
  return [{ code: 'SCR039', severity: 'info', message, fix: 'Export it twice as wide as high if it is a panorama.' }];
}

async function convertRadiance(
  bytes: ArrayBuffer,
  header: RadianceHeader,
  layout: PanoramaLayout,
  read: ReadRadiance,
): Promise<LoadedPanorama> {
  const converted = toEquirectangular((await read.floats(bytes, header)) as PlainPixels, layout, MOST_CONVERTED_PX);
  return panoramaOf(halvesTexture(converted), () => ({ ...converted, data: converted.data.slice() }));
}

function convertPicture(picture: ImageBitmap | null, layout: PanoramaLayout): LoadedPanorama {
  const source = pictureTexture(picture);
  const pixels: PanoramaPixels = ownPixels(source);
  disposeTexture(source);
  const converted = toEquirectangular(pixels as PlainPixels, layout, MOST_CONVERTED_PX);
  return panoramaOf(bytesTexture(converted), () => ({ ...converted, data: converted.data.slice() }));
}

function halvesTexture({ data, widthPx, heightPx, channels }: PlainPixels): DataTexture {
  const halves = new Uint16Array(widthPx * heightPx * 4);
  for (let i = 0; i < widthPx * heightPx; i++) {
    for (let c = 0; c < 3; c++) {
      const value = data[i * channels + (channels === 1 ? 0 : c)] ?? 0;
      halves[i * 4 + c] = DataUtils.toHalfFloat(Math.min(Math.max(value, 0), MAX_HALF));
    }
    halves[i * 4 + 3] = ONE_HALF;
  }
  return radianceTexture({ widthPx, heightPx, channels: 4, data: halves });
}

/** Creates a texture of linear radiance in half floats. */
export function radianceTexture({ data, widthPx, heightPx, channels, fromBottom = false }: HalfPixels): DataTexture {
  const texture = new DataTexture(data, widthPx, heightPx, channels === 1 ? RedFormat : RGBAFormat, HalfFloatType);
  texture.colorSpace = LinearSRGBColorSpace;
  texture.flipY = !fromBottom;
  return texture;
}

const MAX_HALF = 65504;
const ONE_HALF = 0x3c00;

function sizeOf(picture: ImageBitmap | null): readonly [widthPx: number, heightPx: number] {
  return [picture?.width ?? 0, picture?.height ?? 0];
}

/** A panorama that is not filtered for lighting yet. */
export type LoadedPanorama = Omit<LoadedEnvironment, 'withoutLamps' | 'lamps' | 'findLamps' | 'ready'>;

/** Sets a texture up as a panorama. The panorama owns the texture. */
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

async function readPicture(bytes: ArrayBuffer, maxPx: number): Promise<ImageBitmap> {
  const options: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none', imageOrientation: 'flipY' };
  const full = await createImageBitmap(new Blob([bytes]), options).catch(() => {
    throw new PanoramaError('it is no picture. Use a Radiance HDR (.hdr), OpenEXR (.exr), JPEG, PNG, WebP or AVIF file');
  });
  const scale = maxPx / Math.max(full.width, full.height);
  return scale >= 1 ? full : shrink(full, scale);
}

function pictureTexture(picture: ImageBitmap | null): Texture {
  const texture = new Texture(picture);
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
