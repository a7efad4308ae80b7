import { SplatError } from './splats.ts';

const END = 0x06054b50;
const ENTRY = 0x02014b50;
const LOCAL = 0x04034b50;
const END_BYTES = 22;
const ENTRY_BYTES = 46;
const LOCAL_BYTES = 30;
/** The comment after the end record has at most 64 KB. */
const MAX_COMMENT_BYTES = 65_535;

/** A file in an archive. */
export interface ZipFile {
  /** 0: stored; 8: deflated. */
  readonly method: number;
  readonly packed: Uint8Array<ArrayBuffer>;
  /** The size of the file itself. */
  readonly bytes: number;
}

/**
 * Lists the files of a ZIP archive.
 *
 * @param bytes The archive.
 * @returns Files by their names.
 * @throws SplatError if it is incomplete, encrypted or larger than 4 GB.
 *
 * @example
 * const meta = await unzip(readZip(bytes).get('meta.json'));
 */
export function readZip(bytes: Uint8Array<ArrayBuffer>): ReadonlyMap<string, ZipFile> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let end = bytes.length - END_BYTES;
  const lowest = Math.max(0, end - MAX_COMMENT_BYTES);
  while (end >= lowest && view.getUint32(end, true) !== END) end--;
  if (end < lowest) throw new SplatError('its archive is incomplete');
  const files = new Map<string, ZipFile>();
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  for (let i = 0; i < count; i++) {
    if (at + ENTRY_BYTES > bytes.length || view.getUint32(at, true) !== ENTRY) throw new SplatError('its archive is damaged');
    const nameBytes = view.getUint16(at + 28, true);
    const name = new TextDecoder().decode(bytes.subarray(at + ENTRY_BYTES, at + ENTRY_BYTES + nameBytes));
    const packedBytes = view.getUint32(at + 20, true);
    const local = view.getUint32(at + 42, true);
    if (local + LOCAL_BYTES > bytes.length || view.getUint32(local, true) !== LOCAL) throw new SplatError('its archive is damaged');
    const start = local + LOCAL_BYTES + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    if (start + packedBytes > bytes.length) throw new SplatError('its archive is incomplete');
    const packed = bytes.subarray(start, start + packedBytes);
    files.set(name, { method: view.getUint16(at + 10, true), packed, bytes: view.getUint32(at + 24, true) });
    at += ENTRY_BYTES + nameBytes + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  }
  return files;
}

/**
 * Unpacks a file of an archive.
 *
 * @throws SplatError
 *
 * @example
 * const text = new TextDecoder().decode(await unzip(file));
 */
export async function unzip({ method, packed, bytes }: ZipFile): Promise<Uint8Array<ArrayBuffer>> {
  if (method === 0) return packed;
  if (method !== 8) throw new SplatError('its archive is compressed by an unknown method');
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const unpacked = await new Response(stream).arrayBuffer().catch(() => null);
  if (unpacked?.byteLength !== bytes) throw new SplatError('its archive is damaged');
  return new Uint8Array(unpacked);
}

/**
 * Writes an archive of uncompressed files.
 *
 * @param files Files by their names.
 *
 * @example
 * const sog = writeZip(new Map([['meta.json', bytes]]));
 */
export function writeZip(files: ReadonlyMap<string, Uint8Array>): Uint8Array<ArrayBuffer> {
  const names = [...files.keys()].map((name) => new TextEncoder().encode(name));
  const sizes = [...files.values()].map(({ length }) => length);
  const body = names.reduce((sum, name, i) => sum + LOCAL_BYTES + name.length + (sizes[i] ?? 0), 0);
  const directory = names.reduce((sum, name) => sum + ENTRY_BYTES + name.length, 0);
  const out = new Uint8Array(body + directory + END_BYTES);
  const view = new DataView(out.buffer);
  let at = 0;
  let entry = body;
  [...files.values()].forEach((bytes, i) => {
    const name = names[i] ?? new Uint8Array();
    const crc = crc32(bytes);
    view.setUint32(at, LOCAL, true);
    view.setUint16(at + 4, 20, true);
    writeSizes(view, at + 14, crc, bytes.length, name.length);
    out.set(name, at + LOCAL_BYTES);
    out.set(bytes, at + LOCAL_BYTES + name.length);
    view.setUint32(entry, ENTRY, true);
    view.setUint16(entry + 4, 20, true);
    view.setUint16(entry + 6, 20, true);
    writeSizes(view, entry + 16, crc, bytes.length, name.length);
    view.setUint32(entry + 42, at, true);
    out.set(name, entry + ENTRY_BYTES);
    at += LOCAL_BYTES + name.length + bytes.length;
    entry += ENTRY_BYTES + name.length;
  });
  view.setUint32(entry, END, true);
  view.setUint16(entry + 8, files.size, true);
  view.setUint16(entry + 10, files.size, true);
  view.setUint32(entry + 12, directory, true);
  view.setUint32(entry + 16, body, true);
  return out;
}

/** Checksum, both sizes and the length of the name, which both records of a file have in this order. */
function writeSizes(view: DataView, at: number, crc: number, bytes: number, nameBytes: number): void {
  view.setUint32(at, crc, true);
  view.setUint32(at + 4, bytes, true);
  view.setUint32(at + 8, bytes, true);
  view.setUint16(at + 12, nameBytes, true);
}

/** The checksum of ZIP: the reflected polynomial 0xedb88320. */
function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (let i = 0; i < bytes.length; i++) {
    crc ^= bytes[i] ?? 0;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return ~crc >>> 0;
}
