import { readRange } from './read-file.ts';

/** Bytes in which the tracks of a WebM file are looked for. */
const WEBM_HEAD_BYTES = 65_536;
const EBML = Buffer.from([0x1a, 0x45, 0xdf, 0xa3]);
const TRACKS = Buffer.from([0x16, 0x54, 0xae, 0x6b]);
/** The element AlphaMode with the value 1 (Matroska specification, section 5.1.4.1.28.3). */
const ALPHA_MODE = Buffer.from([0x53, 0xc0, 0x81, 0x01]);

const BOX_HEAD_BYTES = 16;
/** More top-level boxes than an MP4 file without fragments has. */
const MAX_BOXES = 64;
const MAX_MOOV_BYTES = 8 * 2 ** 20;
/** Sample entries of H.264, AV1 and VP9 in MP4 files, which have no alpha channel there. HEVC and ProRes may have one. */
const WITHOUT_ALPHA = ['avc1', 'avc3', 'av01', 'vp09'];
const MAY_HAVE_ALPHA = ['hvc1', 'hev1', 'ap4h', 'ap4x'];

/**
 * Whether a video has no alpha channel: an MP4 file with H.264, AV1 or VP9, or a WebM file without AlphaMode. False if it is unclear.
 *
 * @throws Error if the file cannot be read.
 */
export async function isOpaqueVideo(path: string): Promise<boolean> {
  const head = await readRange(path, 0, WEBM_HEAD_BYTES);
  if (head.subarray(0, EBML.length).equals(EBML)) return head.includes(TRACKS) && !head.includes(ALPHA_MODE);
  if (head.toString('latin1', 4, 8) !== 'ftyp') return false;
  const moov = await readMoov(path);
  const names = (entries: readonly string[]) => entries.some((entry) => moov.includes(entry, 0, 'latin1'));
  return names(WITHOUT_ALPHA) && !names(MAY_HAVE_ALPHA);
}

/** Reads the box that describes the tracks of an MP4 file (ISO 14496-12, section 8.2.1), which may be its last. Empty if there is none. */
async function readMoov(path: string): Promise<Buffer> {
  let at = 0;
  for (let i = 0; i < MAX_BOXES; i++) {
    const head = await readRange(path, at, BOX_HEAD_BYTES);
    if (head.length < 8) break;
    const short = head.readUInt32BE(0);
    const size = short === 1 && head.length === BOX_HEAD_BYTES ? Number(head.readBigUInt64BE(8)) : short;
    if (head.toString('latin1', 4, 8) === 'moov') return readRange(path, at, Math.min(size, MAX_MOOV_BYTES));
    if (size < 8) break;
    at += size;
  }
  return Buffer.alloc(0);
}
