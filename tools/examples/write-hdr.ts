/**
 * A Radiance HDR file of linear-sRGB pixels, three numbers each, top row first: shared exponent, without run lengths
 * (G. Ward, "Real Pixels", Graphics Gems II).
 */
export function writeHdr(widthPx: number, heightPx: number, rgb: ArrayLike<number>): Uint8Array<ArrayBuffer> {
  const header = new TextEncoder().encode(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${heightPx} +X ${widthPx}\n`);
  const bytes = new Uint8Array(header.length + widthPx * heightPx * 4);
  bytes.set(header);
  for (let i = 0; i < widthPx * heightPx; i++) {
    const [r = 0, g = 0, b = 0] = [0, 1, 2].map((channel) => rgb[i * 3 + channel] ?? 0);
    const largest = Math.max(r, g, b);
    if (largest < 1e-32) continue;
    const exponent = Math.floor(Math.log2(largest)) + 1;
    const scale = 256 / 2 ** exponent;
    bytes.set([r * scale, g * scale, b * scale, exponent + 128].map(Math.floor), header.length + i * 4);
  }
  return bytes;
}
