import { decode } from 'jpeg-js';
import type { PanoramaPixels } from '../../../nodes/kit/panorama/pixels.ts';

const START_OF_IMAGE = 0xd8;
const START_OF_SCAN = 0xda;
const APP1 = 0xe1;
/** Start of a frame with Huffman coding: baseline, extended, progressive. */
const FRAMES = [0xc0, 0xc1, 0xc2] as const;
const ORIENTATION_TAG = 0x0112;
/** Of the panoramas that pages show, the largest. */
const MOST_MEGAPIXELS = 40;

/**
 * Decodes a JPEG file to bytes without color conversion. Decoders differ by a level here and there, most at edges of color.
 *
 * @returns Null for other files, and for forms that a browser converts: ink colors and photos that are to be turned.
 * @throws Error if the file is damaged.
 */
export function decodeJpeg(file: Uint8Array): PanoramaPixels | null {
  const form = formOf(file);
  if (!form || (form.components !== 1 && form.components !== 3) || form.orientation !== 1) return null;
  const { width, height, data } = decode(file, {
    useTArray: true,
    formatAsRGBA: false,
    tolerantDecoding: false,
    maxResolutionInMP: MOST_MEGAPIXELS,
  });
  return { widthPx: width, heightPx: height, channels: 3, data };
}

/** What the segments before the pixels say (ITU T.81, annex B); null if they say nothing of colors. */
function formOf(file: Uint8Array): { readonly components: number; readonly orientation: number } | null {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (view.byteLength < 4 || view.getUint16(0) !== (0xff00 | START_OF_IMAGE)) return null;
  let orientation = 1;
  for (let at = 2; at + 10 < view.byteLength && view.getUint8(at) === 0xff; at += 2 + view.getUint16(at + 2)) {
    const marker = view.getUint8(at + 1);
    if (marker === START_OF_SCAN) return null;
    if (marker === APP1) orientation = orientationOf(view, at + 4, view.getUint16(at + 2) - 2) ?? orientation;
    if (FRAMES.some((frame) => frame === marker)) return { components: view.getUint8(at + 9), orientation };
  }
  return null;
}

/** The orientation tag of EXIF data, which is a TIFF file after six bytes. */
function orientationOf(view: DataView, start: number, length: number): number | null {
  const isExif = length > 14 && start + length <= view.byteLength && view.getUint32(start) === 0x45786966;
  if (!isExif) return null;
  const tiff = start + 6;
  const little = view.getUint16(tiff) === 0x4949;
  const directory = tiff + view.getUint32(tiff + 4, little);
  if (directory + 2 > start + length) return null;
  const count = view.getUint16(directory, little);
  for (let i = 0, entry = directory + 2; i < count && entry + 12 <= start + length; i++, entry += 12) {
    if (view.getUint16(entry, little) === ORIENTATION_TAG) return view.getUint16(entry + 8, little);
  }
  return null;
}
