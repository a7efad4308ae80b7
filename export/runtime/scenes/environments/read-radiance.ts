import { DataTexture, FloatType, HalfFloatType, LinearSRGBColorSpace } from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import { isCutOff, PanoramaError, type RadianceHeader } from './radiance-header.ts';

/**
 * Decodes Radiance HDR and OpenEXR, to 16-bit floats for drawing. It is injected, so that pages without panoramas do not bundle three.js' loaders (15 KB
 * compressed).
 *
 * @throws PanoramaError if the file is invalid.
 */
export interface ReadRadiance {
  halves(bytes: ArrayBuffer, header: RadianceHeader): DataTexture;
  /**
   * Decodes a file that `halves` has accepted to 32-bit floats, for analysis: rounded to 16 bits, pixels near a threshold could fall on its
   * other side.
   */
  floats(bytes: ArrayBuffer, header: RadianceHeader): PanoramaPixels;
}

export const readRadiance: ReadRadiance = { halves: readHalves, floats: readFloats };

function readFloats(bytes: ArrayBuffer, header: RadianceHeader): PanoramaPixels {
  const { data, width, height, flipY } = parse(bytes, header.format, FloatType);
  if (!(data instanceof Float32Array) || !width || !height) throw new PanoramaError('it holds no picture. Export it again');
  return { widthPx: width, heightPx: height, channels: data.length === width * height ? 1 : 4, data, fromBottom: flipY !== true };
}

function readHalves(bytes: ArrayBuffer, header: RadianceHeader): DataTexture {
  if (isCutOff(bytes, header)) throw new PanoramaError('the file is incomplete. Copy or export it again');
  const { data, width, height, format, flipY } = parse(bytes, header.format, HalfFloatType);
  if (!(data instanceof Uint16Array) || !width || !height) throw new PanoramaError('it holds no picture. Export it again');
  tame(data);
  const texture = new DataTexture(data, width, height, format, HalfFloatType);
  texture.colorSpace = LinearSRGBColorSpace;
  texture.flipY = flipY ?? false;
  return texture;
}

function parse(
  bytes: ArrayBuffer,
  format: RadianceHeader['format'],
  type: typeof FloatType | typeof HalfFloatType,
): ReturnType<HDRLoader['parse']> {
  try {
    return new (format === 'hdr' ? HDRLoader : EXRLoader)().setDataType(type).parse(bytes);
  } catch (error) {
    const reason = error instanceof RangeError ? 'it ends too early' : String(error instanceof Error ? error.message : error);
    throw new PanoramaError(`the file is damaged (${reason.replace(/^THREE\.\w+: /, '')}). Export it again`);
  }
}

/**
 * Limits pixels, because one infinite or negative pixel would spread in filtering: infinity becomes the largest number, NaN and negative
 * values 0.
 */
function tame(halves: Uint16Array): void {
  for (let i = 0; i < halves.length; i++) {
    const half = halves[i] ?? 0;
    if (half >= 0x8000 || half > 0x7c00) halves[i] = 0;
    else if (half === 0x7c00) halves[i] = 0x7bff;
  }
}
