import { encode } from 'fast-png';

/** Pixels of a layer: premultiplied RGBA, rows from the top. */
export interface LayerPixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly pixels: Uint8Array;
}

/** Depth: meters, 0 for nothing, rows from the top. */
export interface DepthPixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly meters: Float32Array;
}

/** Encodes an RGBA PNG with straight alpha. Transparent pixels become black. */
export function encodeLayer(layer: LayerPixels): Uint8Array {
  return encode({ width: layer.widthPx, height: layer.heightPx, data: straightAlpha(layer), channels: 4, depth: 8 });
}

/** The pixels of a layer with straight alpha. */
export function straightAlpha({ pixels }: LayerPixels): Uint8Array {
  const straight = new Uint8Array(pixels);
  for (let i = 0; i < straight.length; i += 4) {
    const alpha = pixels[i + 3] ?? 0;
    if (alpha === 255 || alpha === 0) continue;
    for (let channel = i; channel < i + 3; channel++) {
      straight[channel] = Math.min(255, Math.round(((pixels[channel] ?? 0) * 255) / alpha));
    }
  }
  return straight;
}

const MAX_MM = 65_535;

/** Encodes a 16-bit gray PNG in millimeters, rounded. 0 is nothing; 65535 is 65.535 m or more. */
export function encodeDepth({ widthPx, heightPx, meters }: DepthPixels): Uint8Array {
  const millimeters = Uint16Array.from(meters, (m) => (m > 0 ? Math.min(MAX_MM, Math.max(1, Math.round(m * 1000))) : 0));
  return encode({ width: widthPx, height: heightPx, data: millimeters, channels: 1, depth: 16 });
}
