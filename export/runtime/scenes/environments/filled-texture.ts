import { DataTexture, DataUtils, HalfFloatType, RGBAFormat, SRGBColorSpace, type Texture } from 'three';
import { type FillTarget, fillLamps } from '../../../../nodes/kit/panorama/fill-lamps.ts';
import { type PanoramaPixels, startOfRow } from '../../../../nodes/kit/panorama/pixels.ts';
import type { PartedWork } from '../../gl/spread-work.ts';

type Size = Pick<PanoramaPixels, 'widthPx' | 'heightPx'>;

/**
 * Returns the pixels of a panorama's texture.
 *
 * @returns For a bitmap, its bytes of display-referred sRGB; for halves, those of the texture, which are not copied.
 */
export function texturePixels(texture: Texture): PanoramaPixels {
  const { image } = texture;
  if (image instanceof ImageBitmap) {
    const { width, height } = image;
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    if (!context) throw new Error('The browser gives no canvas to read the panorama.');
    context.drawImage(image, 0, 0);
    // Bitmaps are uploaded as they are, so that their first row is the lowest.
    return { widthPx: width, heightPx: height, channels: 4, data: context.getImageData(0, 0, width, height).data, fromBottom: true };
  }
  const { data, width, height } = image as { data: Uint16Array | Uint8Array; width: number; height: number };
  return { widthPx: width, heightPx: height, channels: texture.format === RGBAFormat ? 4 : 1, data, fromBottom: !texture.flipY };
}

/** A copy of the pixels of a panorama's texture. */
export function ownPixels(texture: Texture): PanoramaPixels {
  const pixels = texturePixels(texture);
  return texture.image instanceof ImageBitmap ? pixels : { ...pixels, data: pixels.data.slice() };
}

/** A copy of a panorama's texture, whose pixels `fill` has yet to write. */
export interface FilledTexture {
  readonly texture: DataTexture;
  readonly fill: PartedWork;
}

/** Creates a copy of a panorama's texture in which the pixels of lamps are filled from their surroundings. */
export function filledTexture(texture: Texture, runs: readonly number[], size: Size): FilledTexture {
  const { image } = texture;
  const isBitmap = image instanceof ImageBitmap;
  const { width: widthPx, height: heightPx } = image as { width: number; height: number };
  const from = isBitmap ? null : (image as { data: Uint16Array | Uint8Array }).data;
  const inHalves = from instanceof Uint16Array;
  const channels = isBitmap || texture.format === RGBAFormat ? 4 : 1;
  const length = widthPx * heightPx * channels;
  const data = inHalves ? new Uint16Array(length) : new Uint8ClampedArray(length);
  // Texture data of three.js has no clamped arrays.
  const filled = new DataTexture(inHalves ? data : new Uint8Array(data.buffer), widthPx, heightPx);
  filled.format = inHalves ? texture.format : RGBAFormat;
  if (inHalves) filled.type = HalfFloatType;
  filled.colorSpace = inHalves ? texture.colorSpace : SRGBColorSpace;
  filled.flipY = texture.flipY;
  function* fill(): PartedWork {
    const rows = Math.max(1, Math.floor(COPIED_PX / widthPx));
    const read = isBitmap ? bitmapReader(image, rows) : null;
    for (let row = 0; row < heightPx; row += rows) {
      const [start, end] = [row * widthPx * channels, Math.min(row + rows, heightPx) * widthPx * channels];
      data.set(read ? read(row).subarray(0, end - start) : (from as Uint8Array | Uint16Array).subarray(start, end), start);
      yield 1;
    }
    const pixels = { widthPx, heightPx, channels, fromBottom: isBitmap || !texture.flipY } as const;
    fillLamps(data instanceof Uint16Array ? halvesTarget({ ...pixels, data }) : bytesTarget({ ...pixels, data }), runs, size);
    yield 1;
  }
  return { texture: filled, fill: fill() };
}

/** Pixels that are copied in one turn: 8 MB in half floats. */
const COPIED_PX = 2 ** 20;

/** Creates what reads `rows` rows of a bitmap. */
function bitmapReader(image: ImageBitmap, rows: number): (row: number) => Uint8ClampedArray {
  const context = new OffscreenCanvas(image.width, rows).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('The browser gives no canvas to read the panorama.');
  return (row) => {
    context.clearRect(0, 0, image.width, rows);
    context.drawImage(image, 0, -row);
    return context.getImageData(0, 0, image.width, rows).data;
  };
}

/**
 * Creates a texture of display-referred bytes with four channels.
 *
 * @throws Error for other pixels.
 */
export function bytesTexture({ data, widthPx, heightPx, channels, fromBottom = false }: PanoramaPixels): DataTexture {
  if (data.BYTES_PER_ELEMENT !== 1 || channels !== 4) throw new Error('Panoramas are created from bytes with four channels.');
  // Texture data of three.js has no clamped arrays.
  const texture = new DataTexture(new Uint8Array(data.buffer as ArrayBuffer, data.byteOffset, data.byteLength), widthPx, heightPx);
  texture.format = RGBAFormat;
  texture.colorSpace = SRGBColorSpace;
  texture.flipY = !fromBottom;
  return texture;
}

function halvesTarget(pixels: PanoramaPixels): FillTarget {
  const { widthPx, heightPx, channels, data } = pixels;
  const indexOf = (x: number, y: number, channel: number): number => startOfRow(pixels, y) + x * channels + (channels === 1 ? 0 : channel);
  return {
    widthPx,
    heightPx,
    get: (x, y, channel) => DataUtils.fromHalfFloat(data[indexOf(x, y, channel)] ?? 0),
    set: (x, y, channel, value) => {
      data[indexOf(x, y, channel)] = DataUtils.toHalfFloat(value);
    },
  };
}

/**
 * Access to 8-bit pixels for the filling of lamps. Encoded bytes are averaged without decoding: the neighbors of a fill have similar
 * brightness, so the error is small.
 */
function bytesTarget(pixels: PanoramaPixels): FillTarget {
  const { widthPx, heightPx, channels, data } = pixels;
  return {
    widthPx,
    heightPx,
    get: (x, y, channel) => data[startOfRow(pixels, y) + x * channels + channel] ?? 0,
    set: (x, y, channel, value) => {
      data[startOfRow(pixels, y) + x * channels + channel] = value;
    },
  };
}
