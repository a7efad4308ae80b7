import { DataUtils } from 'three';

/** Encodes linear RGB pixels, rows from the top, as an OpenEXR file: one part, scan lines, half floats, no compression. */
export function writeExr(widthPx: number, heightPx: number, rgb: ArrayLike<number>): Uint8Array<ArrayBuffer> {
  const bytes: number[] = [];
  const int = (value: number): unknown => bytes.push(value & 255, (value >> 8) & 255, (value >> 16) & 255, (value >> 24) & 255);
  const text = (value: string): unknown => bytes.push(...new TextEncoder().encode(value), 0);
  const float = (value: number): unknown => bytes.push(...new Uint8Array(new Float32Array([value]).buffer));
  const attribute = (name: string, type: string, size: number, write: () => void): void => {
    text(name);
    text(type);
    int(size);
    write();
  };
  const box = (): void => [0, 0, widthPx - 1, heightPx - 1].forEach(int);
  int(20000630);
  int(2);
  // Channels in alphabetical order: name, half float, not linear, one sample per pixel.
  attribute('channels', 'chlist', 3 * 18 + 1, () => {
    for (const name of ['B', 'G', 'R']) {
      text(name);
      for (const value of [1, 0, 1, 1]) int(value);
    }
    bytes.push(0);
  });
  attribute('compression', 'compression', 1, () => bytes.push(0));
  attribute('dataWindow', 'box2i', 16, box);
  attribute('displayWindow', 'box2i', 16, box);
  attribute('lineOrder', 'lineOrder', 1, () => bytes.push(0));
  attribute('pixelAspectRatio', 'float', 4, () => float(1));
  attribute('screenWindowCenter', 'v2f', 8, () => [0, 0].forEach(float));
  attribute('screenWindowWidth', 'float', 4, () => float(1));
  bytes.push(0);
  const lineBytes = widthPx * 6;
  const first = bytes.length + heightPx * 8;
  for (let y = 0; y < heightPx; y++) {
    int(first + y * (lineBytes + 8));
    int(0);
  }
  for (let y = 0; y < heightPx; y++) {
    int(y);
    int(lineBytes);
    for (const channel of [2, 1, 0]) {
      for (let x = 0; x < widthPx; x++) {
        const half = DataUtils.toHalfFloat(rgb[(y * widthPx + x) * 3 + channel] ?? 0);
        bytes.push(half & 255, half >> 8);
      }
    }
  }
  return new Uint8Array(bytes);
}
