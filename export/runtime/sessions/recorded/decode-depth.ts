import { decode } from 'fast-png';
import type { SessionFile } from '../session-format.ts';

type DepthFormat = NonNullable<SessionFile['depth']>;

/**
 * Decodes a depth image to meters along the camera's axis, row-major from the top, 0 where unknown. Browsers decode PNG to 8 bits, so a
 * separate decoder is used.
 *
 * @throws Error if the file is not a 16-bit PNG with one channel and the size of `format`.
 */
export function decodeDepth(bytes: ArrayBuffer, format: DepthFormat): Float32Array<ArrayBuffer> {
  const { width, height, depth, channels, data } = decodePng(bytes);
  if (depth !== 16 || channels !== 1) throw new Error(`it has ${channels} channels of ${depth} bits instead of one of 16`);
  if (width !== format.widthPx || height !== format.heightPx) {
    throw new Error(`it has ${width} × ${height} pixels, and session.json says ${format.widthPx} × ${format.heightPx}`);
  }
  const meters = new Float32Array(width * height);
  const { metresPerUnit, kind, intrinsics } = format;
  for (let i = 0; i < meters.length; i++) meters[i] = (data[i] ?? 0) * metresPerUnit;
  if (kind === 'range') {
    const { fxPx, fyPx, cxPx, cyPx } = intrinsics;
    for (let y = 0; y < height; y++) {
      const rayY = (y + 0.5 - cyPx) / fyPx;
      for (let x = 0; x < width; x++) {
        const i = y * width + x;
        meters[i] = (meters[i] ?? 0) / Math.hypot((x + 0.5 - cxPx) / fxPx, rayY, 1);
      }
    }
  }
  return meters;
}

function decodePng(bytes: ArrayBuffer): ReturnType<typeof decode> {
  try {
    return decode(bytes);
  } catch {
    throw new Error('it is not a whole PNG file');
  }
}
