import type { FileHandle } from 'node:fs/promises';

/** Limit for the tables of a movie. Those of an hour take a few megabytes. */
const MAX_TABLE_BYTES = 64 * 2 ** 20;
/** Limit for the number of top-level boxes. A fragmented hour has two per second. */
const MAX_BOXES = 20_000;

/** Checks an MP4 after its signature (ISO 14496-12, §4.2 and §8). Returns the predicate of a message; null if the file is valid. */
export async function mp4Fault(file: FileHandle, size: number): Promise<string | null> {
  const found = new Set<string>();
  let at = 0;
  for (let boxes = 0; at < size && boxes < MAX_BOXES; boxes++) {
    const head = await readAt(file, at, 16);
    if (head.length < 8) return CUT_OFF;
    const type = head.toString('latin1', 4, 8);
    const short = head.readUInt32BE(0);
    if (short === 1 && head.length < 16) return CUT_OFF;
    // 0: the box extends to the end of the file. 1: a 64-bit length follows.
    const length = short === 0 ? size - at : short === 1 ? Number(head.readBigUInt64BE(8)) : short;
    if (length < 8 || !/^[\x20-\x7e\xa9]{4}$/.test(type)) return BROKEN;
    if (at + length > size) return CUT_OFF;
    found.add(type);
    if (type === 'moov') {
      if (length > MAX_TABLE_BYTES) return BROKEN;
      // The handler of a video track (§8.4.3).
      if (!(await readAt(file, at, length)).includes('vide')) return NO_IMAGES;
    }
    at += length;
  }
  if (!found.has('moov')) return `${CUT_OFF_HEAD} its index (“moov”) is missing.`;
  return found.has('mdat') ? null : NO_IMAGES;
}

const EBML = 0x1a45dfa3;
const SEGMENT = 0x18538067;
const TRACKS = 0x1654ae6b;
const CLUSTER = 0x1f43b675;

/**
 * Checks a WebM after its signature (RFC 8794, §4 to §6; RFC 9559, §5.1). Returns the predicate of a message; null if the file is
 * valid.
 */
export async function webmFault(file: FileHandle, size: number): Promise<string | null> {
  let at = 0;
  let isInSegment = false;
  for (let elements = 0; at < size && elements < MAX_BOXES; elements++) {
    const head = readElement(await readAt(file, at, 12));
    if (head === null) return isInSegment ? CUT_OFF : BROKEN;
    const { id, headBytes, length } = head;
    const end = length === null ? size : at + headBytes + length;
    if (end > size) return CUT_OFF;
    if (id === TRACKS) {
      if (end - at > MAX_TABLE_BYTES) return BROKEN;
      // Ids of video codecs start with `V_` (RFC 9559, §27.4).
      return (await readAt(file, at, end - at)).includes('V_') ? null : NO_IMAGES;
    }
    if (id === CLUSTER) return NO_IMAGES;
    if (!isInSegment && id !== EBML && id !== SEGMENT) return BROKEN;
    // The children of the segment follow.
    isInSegment ||= id === SEGMENT;
    at = id === SEGMENT ? at + headBytes : end;
  }
  return isInSegment ? NO_IMAGES : CUT_OFF;
}

const CUT_OFF_HEAD = 'is incomplete or not a video:';
const CUT_OFF = 'is incomplete: a chunk is longer than the file.';
const BROKEN = 'is broken: its content is not a video.';
const NO_IMAGES = 'has no images in it.';

/** Reads the id (1 to 4 bytes) and length (1 to 8 bytes) of an element. A length of all ones is unknown and becomes null. */
function readElement(head: Buffer): { readonly id: number; readonly headBytes: number; readonly length: number | null } | null {
  const idBytes = Math.clz32(head[0] ?? 0) - 23;
  const lengthBytes = Math.clz32(head[idBytes] ?? 0) - 23;
  if (idBytes > 4 || lengthBytes > 8 || head.length < idBytes + lengthBytes) return null;
  const id = head.readUIntBE(0, idBytes);
  const mask = 2 ** (8 - lengthBytes) - 1;
  let length = (head[idBytes] ?? 0) & mask;
  let isUnknown = length === mask;
  for (let i = 1; i < lengthBytes; i++) {
    const byte = head[idBytes + i] ?? 0;
    length = length * 256 + byte;
    isUnknown &&= byte === 255;
  }
  return { id, headBytes: idBytes + lengthBytes, length: isUnknown ? null : length };
}

/** Reads bytes; fewer at the end of the file. */
async function readAt(file: FileHandle, at: number, length: number): Promise<Buffer> {
  const bytes = Buffer.alloc(length);
  const { bytesRead } = await file.read(bytes, 0, length, at);
  return bytes.subarray(0, bytesRead);
}
