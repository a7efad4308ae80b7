import { FloatType, HalfFloatType } from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import { isCutOff, PanoramaError, type RadianceHeader } from './radiance-header.ts';

/** Pixels of 16-bit floats, finite and not negative. */
export type HalfPixels = PanoramaPixels & { readonly data: Uint16Array<ArrayBuffer> };

/**
 * Decodes Radiance HDR and OpenEXR, to 16-bit floats for drawing. It is injected, so that pages without panoramas do not bundle three.js' loaders (15 KB
 * compressed), and because pages and the preview decode in a worker: 8192 × 4096 pixels take seconds.
 *
 * @throws PanoramaError if the file is invalid.
 */
export interface ReadRadiance {
  halves(bytes: ArrayBuffer, header: RadianceHeader): HalfPixels | Promise<HalfPixels>;
  /**
   * Decodes to 32-bit floats, for analysis: rounded to 16 bits, pixels near a threshold could fall on its other side. Values may be negative or
   * not finite.
   */
  floats(bytes: ArrayBuffer, header: RadianceHeader): PanoramaPixels | Promise<PanoramaPixels>;
}

/** Decodes at once, for renders and for workers. */
export const readRadiance = { halves: readHalves, floats: readFloats } satisfies ReadRadiance;

function readFloats(bytes: ArrayBuffer, header: RadianceHeader): PanoramaPixels {
  return parse(bytes, header, FloatType);
}

function readHalves(bytes: ArrayBuffer, header: RadianceHeader): HalfPixels {
  const pixels = parse(bytes, header, HalfFloatType) as HalfPixels;
  tame(pixels.data);
  return pixels;
}

function parse(bytes: ArrayBuffer, header: RadianceHeader, type: typeof FloatType | typeof HalfFloatType): PanoramaPixels {
  if (isCutOff(bytes, header)) throw new PanoramaError('the file is incomplete. Copy or export it again');
  const { data, width, height, flipY } = load(bytes, header.format, type);
  const isWanted = type === FloatType ? data instanceof Float32Array : data instanceof Uint16Array;
  const channels = data && width && height ? data.length / (width * height) : 0;
  if (!isWanted || !width || !height || (channels !== 1 && channels !== 4)) {
    throw new PanoramaError('it holds no picture. Export it again');
  }
  return { widthPx: width, heightPx: height, channels, data: data as Float32Array | Uint16Array, fromBottom: flipY !== true };
}

function load(bytes: ArrayBuffer, format: RadianceHeader['format'], type: typeof FloatType | typeof HalfFloatType) {
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
