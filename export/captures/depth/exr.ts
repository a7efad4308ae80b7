import { CaptureError } from '../../../nodes/kit/capture.ts';
import type { DepthMap } from './depth-map.ts';
import { checkSize } from './read-depth.ts';

/**
 * Reads one channel of an OpenEXR file of scan lines: uncompressed, RLE, ZIPS or ZIP, which hold depth without loss (openexr.com, “OpenEXR
 * File Layout”). three.js' reader accepts channels of colors only, and renderers name depth `Z`, `V` or `Depth.V`.
 */

interface Channel {
  readonly name: string;
  /** 0: 32-bit whole numbers, 1: 16-bit floats, 2: 32-bit floats. */
  readonly type: number;
}

interface Header {
  readonly channels: readonly Channel[];
  readonly compression: number;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly firstRow: number;
  /** Where the header ends. */
  readonly end: number;
}

const MAGIC = 20000630;
const COMPRESSIONS = ['none', 'RLE', 'ZIPS', 'ZIP', 'PIZ', 'PXR24', 'B44', 'B44A'];
/** Scan lines per block, by compression. */
const BLOCK_ROWS = [1, 1, 1, 16];
const BYTES = [4, 2, 4];
/** Names of channels that hold depth, the surest first. */
const DEPTH_NAMES = [/(^|\.)Z$/, /depth.*\.(V|X|Y|R)$/i, /^depth$/i, /^V$/, /^Y$/, /^R$/, /\.R$/];

/**
 * @param inflate Decompresses zlib data.
 * @throws CaptureError
 */
export function readExr(bytes: Uint8Array, name: string, inflate: (bytes: Uint8Array) => Uint8Array): DepthMap {
  try {
    return readLines(bytes, name, inflate);
  } catch (error) {
    // DataView throws a RangeError beyond the end, and zlib errors of its own.
    if (error instanceof CaptureError) throw error;
    throw new CaptureError(`${name} is incomplete or damaged`);
  }
}

function readLines(bytes: Uint8Array, name: string, inflate: (bytes: Uint8Array) => Uint8Array): DepthMap {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const header = readHeader(view, name);
  const { channels, compression, widthPx, heightPx, firstRow, end } = header;
  const chosen = DEPTH_NAMES.flatMap((pattern) => channels.find((channel) => pattern.test(channel.name)) ?? [])[0];
  if (!chosen) throw new CaptureError(`${name} has no channel of depth, only ${channels.map((channel) => channel.name).join(', ')}`);
  const perPixel = channels.reduce((sum, { type }) => sum + (BYTES[type] ?? 0), 0);
  const before = channels.slice(0, channels.indexOf(chosen)).reduce((sum, { type }) => sum + (BYTES[type] ?? 0), 0);
  const blockRows = BLOCK_ROWS[compression] ?? 1;
  const values = new Float32Array(widthPx * heightPx);
  for (let block = 0; block < Math.ceil(heightPx / blockRows); block++) {
    const at = Number(view.getBigUint64(end + 8 * block, true));
    const top = view.getInt32(at, true) - firstRow;
    const size = view.getInt32(at + 4, true);
    const rows = Math.min(blockRows, heightPx - top);
    const rawBytes = rows * widthPx * perPixel;
    if (top < 0 || rows < 1 || size < 0 || at + 8 + size > bytes.length) throw new RangeError();
    const packed = bytes.subarray(at + 8, at + 8 + size);
    // A block that does not become smaller is stored as it is.
    const raw =
      compression === 0 || size >= rawBytes ? packed : unfiltered(compression === 1 ? unpackRuns(packed, rawBytes) : inflate(packed));
    if (raw.length < rawBytes) throw new RangeError();
    const data = new DataView(raw.buffer, raw.byteOffset, raw.length);
    for (let row = 0; row < rows; row++) {
      const from = (row * perPixel + before) * widthPx;
      for (let column = 0; column < widthPx; column++) {
        values[(top + row) * widthPx + column] = readSample(data, from + column * (BYTES[chosen.type] ?? 4), chosen.type);
      }
    }
  }
  return { widthPx, heightPx, values };
}

function readHeader(view: DataView, name: string): Header {
  if (view.byteLength < 8 || view.getUint32(0, true) !== MAGIC) throw new CaptureError(`${name} is not an EXR file`);
  if ((view.getUint32(4, true) & 0x1a00) !== 0) {
    throw new CaptureError(`${name} has tiles, several parts or deep pixels. Save it with scan lines and one part`);
  }
  let at = 8;
  const text = (): string => {
    let word = '';
    for (let code = view.getUint8(at++); code !== 0; code = view.getUint8(at++)) word += String.fromCharCode(code);
    return word;
  };
  let channels: readonly Channel[] = [];
  let compression = -1;
  let box = [0, 0, -1, -1];
  for (let attribute = text(); attribute !== ''; attribute = text()) {
    text();
    const end = at + 4 + view.getUint32(at, true);
    at += 4;
    if (attribute === 'channels') channels = readChannels(view, at, name);
    if (attribute === 'compression') compression = view.getUint8(at);
    if (attribute === 'dataWindow') box = [0, 4, 8, 12].map((offset) => view.getInt32(at + offset, true));
    at = end;
  }
  if (!(compression in BLOCK_ROWS)) {
    throw new CaptureError(`${name} has the compression ${COMPRESSIONS[compression] ?? `number ${compression}`}. Save it with ZIP`);
  }
  const [left = 0, top = 0, right = 0, bottom = 0] = box;
  const [widthPx, heightPx] = checkSize(right - left + 1, bottom - top + 1, name);
  return { channels, compression, widthPx, heightPx, firstRow: top, end: at };
}

function readChannels(view: DataView, from: number, name: string): readonly Channel[] {
  const channels: Channel[] = [];
  for (let at = from; view.getUint8(at) !== 0; at += 16) {
    let channel = '';
    for (let code = view.getUint8(at++); code !== 0; code = view.getUint8(at++)) channel += String.fromCharCode(code);
    const type = view.getInt32(at, true);
    if (!(type in BYTES) || view.getInt32(at + 8, true) !== 1 || view.getInt32(at + 12, true) !== 1) {
      throw new CaptureError(`the channel ${channel} of ${name} is reduced, which is not supported`);
    }
    channels.push({ name: channel, type });
  }
  return channels;
}

function readSample(data: DataView, at: number, type: number): number {
  if (type === 2) return data.getFloat32(at, true);
  if (type === 0) return data.getUint32(at, true);
  const half = data.getUint16(at, true);
  const exponent = (half >> 10) & 31;
  const fraction = half & 1023;
  const size =
    exponent === 31 ? (fraction ? Number.NaN : Infinity) : exponent === 0 ? fraction * 2 ** -24 : (1024 + fraction) * 2 ** (exponent - 25);
  return half & 0x8000 ? -size : size;
}

/** Undoes the filter before compression: differences of neighbors, of even bytes first and then odd ones. */
function unfiltered(bytes: Uint8Array): Uint8Array {
  const sums = Uint8Array.from(bytes);
  for (let i = 1; i < sums.length; i++) sums[i] = (sums[i - 1] ?? 0) + (sums[i] ?? 0) - 128;
  const half = (sums.length + 1) >> 1;
  return sums.map((_, i) => sums[(i >> 1) + (i & 1 ? half : 0)] ?? 0);
}

function unpackRuns(bytes: Uint8Array, length: number): Uint8Array {
  const out = new Uint8Array(length);
  let to = 0;
  for (let at = 0; at < bytes.length; ) {
    const count = ((bytes[at++] ?? 0) << 24) >> 24;
    if (count < 0) {
      out.set(bytes.subarray(at, at - count), to);
      at -= count;
      to -= count;
    } else {
      out.fill(bytes[at++] ?? 0, to, to + count + 1);
      to += count + 1;
    }
  }
  if (to !== length) throw new RangeError();
  return out;
}
