import { CaptureError } from '../../../nodes/kit/capture.ts';
import type { DepthMap } from './depth-map.ts';

const MAX_PIXELS = 8192 * 8192;

/**
 * Reads a PFM file of one channel: a text header, then 32-bit floats, the bottom row first.
 *
 * @throws CaptureError
 */
export function readPfm(bytes: Uint8Array, name: string): DepthMap {
  const words: string[] = [];
  let at = 0;
  while (words.length < 4 && at < bytes.length) {
    const from = at;
    while (at < bytes.length && !isSpace(bytes[at])) at++;
    if (at > from) words.push(String.fromCharCode(...bytes.subarray(from, Math.min(at, from + 32))));
    // One space ends the header; the next byte belongs to the data.
    at++;
  }
  const [type = '', width = '', height = '', scale = ''] = words;
  if (type === 'PF') throw new CaptureError(`${name} is a PFM file of colors, not of depth`);
  if (type !== 'Pf') throw new CaptureError(`${name} is not a PFM file`);
  const [widthPx, heightPx] = checkSize(Number(width), Number(height), name);
  const order = Number(scale);
  if (!Number.isFinite(order) || order === 0) throw new CaptureError(`the header of ${name} is invalid`);
  return { widthPx, heightPx, values: readFloats(bytes.subarray(at), widthPx, heightPx, order < 0, true, name) };
}

/**
 * Reads a depth map of COLMAP: `width&height&channels&`, then 32-bit floats (colmap.github.io/format.html, “Depth and Normal Map Files”).
 *
 * @throws CaptureError
 */
export function readColmapDepth(bytes: Uint8Array, name: string): DepthMap {
  const head = String.fromCharCode(...bytes.subarray(0, 40));
  const [whole, width, height, channels] = /^(\d+)&(\d+)&(\d+)&/.exec(head) ?? [];
  if (whole === undefined) throw new CaptureError(`${name} is not a depth map of COLMAP`);
  if (channels !== '1') throw new CaptureError(`${name} has ${channels} channels instead of 1: it is not a depth map`);
  const [widthPx, heightPx] = checkSize(Number(width), Number(height), name);
  return { widthPx, heightPx, values: readFloats(bytes.subarray(whole.length), widthPx, heightPx, true, false, name) };
}

/** @throws CaptureError for sizes that no depth map has. */
export function checkSize(widthPx: number, heightPx: number, name: string): readonly [number, number] {
  if (!Number.isInteger(widthPx) || !Number.isInteger(heightPx) || widthPx < 1 || heightPx < 1) {
    throw new CaptureError(`${name} has no size`);
  }
  if (widthPx * heightPx > MAX_PIXELS) throw new CaptureError(`${name} is ${widthPx} × ${heightPx} pixels, more than 8192 × 8192`);
  return [widthPx, heightPx];
}

function readFloats(
  bytes: Uint8Array,
  widthPx: number,
  heightPx: number,
  isLittleEndian: boolean,
  isUpwards: boolean,
  name: string,
): Float32Array {
  if (bytes.length < 4 * widthPx * heightPx) {
    throw new CaptureError(`${name} is incomplete: it has ${bytes.length} bytes of depth instead of ${4 * widthPx * heightPx}`);
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const values = new Float32Array(widthPx * heightPx);
  for (let row = 0; row < heightPx; row++) {
    const from = isUpwards ? heightPx - 1 - row : row;
    for (let column = 0; column < widthPx; column++) {
      values[row * widthPx + column] = view.getFloat32(4 * (from * widthPx + column), isLittleEndian);
    }
  }
  return values;
}

function isSpace(byte: number | undefined): boolean {
  return byte === 0x20 || (byte !== undefined && byte >= 0x09 && byte <= 0x0d);
}
