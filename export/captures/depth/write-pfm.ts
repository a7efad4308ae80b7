import type { DepthMap } from './depth-map.ts';

/** Writes a PFM file of one channel, little-endian, the bottom row first (netpbm.sourceforge.net/doc/pfm.html). */
export function writePfm({ widthPx, heightPx, values }: DepthMap): Uint8Array {
  const head = new TextEncoder().encode(`Pf\n${widthPx} ${heightPx}\n-1.0\n`);
  const bytes = new Uint8Array(head.length + 4 * values.length);
  bytes.set(head);
  const view = new DataView(bytes.buffer, head.length);
  values.forEach((value, i) => {
    const row = heightPx - 1 - Math.floor(i / widthPx);
    view.setFloat32(4 * (row * widthPx + (i % widthPx)), value, true);
  });
  return bytes;
}
