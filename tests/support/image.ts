import { decode, encode } from 'fast-png';

/** RGBA8, rows from the top. The caller knows whether alpha is premultiplied. */
export interface RgbaImage {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array;
}

/** Decodes a PNG, such as a screenshot. Rejects gray and palette images and 16 bits per channel. */
export function decodeImage(png: Uint8Array): RgbaImage {
  const { width, height, depth, channels, data } = decode(png);
  if (depth !== 8 || (channels !== 3 && channels !== 4) || !(data instanceof Uint8Array)) {
    throw new Error(`Expected a PNG of 3 or 4 channels with 8 bits, not ${channels} with ${depth}.`);
  }
  return { width, height, data: channels === 4 ? data : addAlpha(data) };
}

export function encodeImage({ width, height, data }: RgbaImage): Uint8Array {
  return encode({ width, height, data, depth: 8, channels: 4 });
}

/** Converts the result of `readPixels`, whose rows start at the bottom. `rgba` may be an array of plain numbers from a page. */
export function fromGl(width: number, height: number, rgba: ArrayLike<number>): RgbaImage {
  const rowBytes = width * 4;
  if (rgba.length !== rowBytes * height) throw new Error(`${rgba.length} bytes are no picture of ${width}×${height}.`);
  const source = new Uint8Array(rgba);
  const data = new Uint8Array(source.length);
  for (let y = 0; y < height; y++) data.set(source.subarray(y * rowBytes, (y + 1) * rowBytes), (height - 1 - y) * rowBytes);
  return { width, height, data };
}

/** `[r, g, b, a]` of a pixel; (0, 0) is the top left. */
export function pixelAt({ width, height, data }: RgbaImage, x: number, y: number): readonly [number, number, number, number] {
  if (x < 0 || y < 0 || x >= width || y >= height) throw new Error(`(${x}, ${y}) lies outside ${width}×${height}.`);
  const [r = 0, g = 0, b = 0, a = 0] = data.subarray((y * width + x) * 4, (y * width + x) * 4 + 4);
  return [r, g, b, a];
}

function addAlpha(rgb: Uint8Array): Uint8Array {
  const rgba = new Uint8Array((rgb.length / 3) * 4).fill(255);
  // A view of each pixel would take ten times as long.
  for (let from = 0, to = 0; from < rgb.length; from += 3, to += 4) {
    rgba[to] = rgb[from] ?? 0;
    rgba[to + 1] = rgb[from + 1] ?? 0;
    rgba[to + 2] = rgb[from + 2] ?? 0;
  }
  return rgba;
}
