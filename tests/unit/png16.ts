import { deflateSync, inflateSync } from 'node:zlib';
import type { DepthImage } from '../../tools/sessions/depth-image.ts';

// 16-bit PNG of one channel with zlib alone: another reader than the one under test, and many times faster inside Jest.

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);

export function readPng16(png: Buffer, metresPerUnit: number): DepthImage {
  const [widthPx, heightPx] = [png.readUInt32BE(16), png.readUInt32BE(20)];
  const parts: Buffer[] = [];
  for (let at = SIGNATURE.length; at < png.length; ) {
    const length = png.readUInt32BE(at);
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + length));
    at += length + 12;
  }
  const rows = unfilter(inflateSync(Buffer.concat(parts)), widthPx * 2, heightPx);
  const meters = new Float32Array(widthPx * heightPx);
  for (let i = 0; i < meters.length; i++) meters[i] = ((rows[i * 2] ?? 0) * 256 + (rows[i * 2 + 1] ?? 0)) * metresPerUnit;
  return { widthPx, heightPx, meters };
}

/** PNG §9: each byte was predicted from those to its left and above. */
function unfilter(filtered: Uint8Array, rowBytes: number, rows: number): Uint8Array {
  const out = new Uint8Array(rowBytes * rows);
  for (let row = 0; row < rows; row++) {
    const kind = filtered[row * (rowBytes + 1)] ?? 0;
    for (let i = 0; i < rowBytes; i++) {
      const at = row * rowBytes + i;
      const a = i < 2 ? 0 : (out[at - 2] ?? 0);
      const b = row === 0 ? 0 : (out[at - rowBytes] ?? 0);
      const c = i < 2 || row === 0 ? 0 : (out[at - rowBytes - 2] ?? 0);
      out[at] = (filtered[row * (rowBytes + 1) + 1 + i] ?? 0) + predict(kind, a, b, c);
    }
  }
  return out;
}

function predict(kind: number, a: number, b: number, c: number): number {
  if (kind === 1) return a;
  if (kind === 2) return b;
  if (kind === 3) return (a + b) >> 1;
  if (kind === 0) return 0;
  // Paeth: the nearest of the three to a + b − c.
  const [pa, pb, pc] = [b > c ? b - c : c - b, a > c ? a - c : c - a, a + b > 2 * c ? a + b - 2 * c : 2 * c - a - b];
  if (pa <= pb && pa <= pc) return a;
  return pb <= pc ? b : c;
}

/** Without prediction. */
export function writePng16(units: Uint16Array, widthPx: number, heightPx: number): Buffer {
  const raw = Buffer.alloc((widthPx * 2 + 1) * heightPx);
  units.forEach((unit, i) => {
    raw.writeUInt16BE(unit, Math.floor(i / widthPx) * (widthPx * 2 + 1) + 1 + (i % widthPx) * 2);
  });
  const header = Buffer.alloc(13);
  header.writeUInt32BE(widthPx, 0);
  header.writeUInt32BE(heightPx, 4);
  header.set([16, 0, 0, 0, 0], 8);
  return Buffer.concat([SIGNATURE, chunk('IHDR', header), chunk('IDAT', deflateSync(raw)), chunk('IEND', Buffer.alloc(0))]);
}

function chunk(kind: string, data: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(kind, 'latin1'), data]);
  const out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}
