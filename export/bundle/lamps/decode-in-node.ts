import { decode as decodePng } from 'fast-png';
import { layoutOf } from '../../../nodes/kit/panorama/layouts.ts';
import type { PanoramaPixels } from '../../../nodes/kit/panorama/pixels.ts';
import { readRadianceHeader } from '../../runtime/scenes/environments/radiance-header.ts';
import { readRadiance } from '../../runtime/scenes/environments/read-radiance.ts';
import { decodeJpeg } from './decode-jpeg.ts';

/** Maximum side of a PNG or JPEG. Larger images may be reduced by the page, which then needs the lamps of the reduced image. */
const MAX_PICTURE_PX = 4096;
const PNG_SIGNATURE = [0x89, 0x50, 0x4e, 0x47] as const;

/**
 * Decodes a panorama as a page does: HDR and EXR to floats, PNG and JPEG to bytes without color conversion.
 *
 * @returns Null if the page must find the lamps: for other formats, for forms of PNG and JPEG that a browser converts, and for images that
 * the page reduces or converts.
 * @throws Error if the file is damaged.
 */
export function decodeInNode(file: Uint8Array): PanoramaPixels | null {
  const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength) as ArrayBuffer;
  const header = readRadianceHeader(bytes);
  if (header) return isConverted(header.widthPx, header.heightPx) ? null : readRadiance.floats(bytes, header);
  const pixels = PNG_SIGNATURE.every((byte, i) => file[i] === byte) ? plainPng(file) : decodeJpeg(file);
  if (!pixels || Math.max(pixels.widthPx, pixels.heightPx) > MAX_PICTURE_PX || isConverted(pixels.widthPx, pixels.heightPx)) return null;
  return pixels;
}

function plainPng(file: Uint8Array): PanoramaPixels | null {
  const { width, height, channels, depth, data, palette } = decodePng(file);
  const plain = depth === 8 && palette === undefined && (channels === 1 || channels === 3) && data instanceof Uint8Array;
  return plain ? { widthPx: width, heightPx: height, channels, data } : null;
}

/**
 * Whether the page converts a panorama of this size, because it is a mirror ball or a cube. The page then needs the lamps of the result.
 */
function isConverted(widthPx: number, heightPx: number): boolean {
  const layout = layoutOf(widthPx, heightPx);
  return layout !== null && layout !== 'equirectangular';
}
