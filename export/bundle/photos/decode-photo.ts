import { decode as decodePng } from 'fast-png';
import type { Photo } from '../../captures/undistort.ts';
import type { AvifCodec } from './avif.ts';
import { isAvif, isJpeg, isPng } from './image-form.ts';

/**
 * Reads the pixels of a JPEG, PNG or AVIF file. Transparent ones become opaque.
 *
 * @throws Error whose message is the end of a sentence about the photograph: `is damaged (…)`.
 */
export async function decodePhoto(file: Uint8Array, jpeg: (file: Uint8Array) => Promise<Photo>, avif: AvifCodec): Promise<Photo> {
  try {
    if (isJpeg(file)) return await jpeg(file);
    if (isAvif(file)) return await avif.decode(file);
    if (isPng(file)) return fromPng(file);
  } catch (error) {
    throw new Error(`is damaged (${error instanceof Error ? error.message : String(error)})`);
  }
  throw new Error('is neither a JPEG nor a PNG file');
}

function fromPng(file: Uint8Array): Photo {
  const { width, height, data, channels, depth, palette } = decodePng(file);
  const rgba = new Uint8Array(width * height * 4).fill(255);
  const shift = depth === 16 ? 8 : 0;
  for (let i = 0; i < width * height; i++) {
    const listed = palette?.[data[i] ?? 0];
    for (let c = 0; c < 3; c++) {
      const value = listed ? listed[c] : (data[i * channels + (channels < 3 ? 0 : c)] ?? 0) >> shift;
      rgba[4 * i + c] = value ?? 0;
    }
  }
  return { widthPx: width, heightPx: height, data: rgba };
}
