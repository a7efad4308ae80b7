import { checkCount, HARMONICS_WORDS, SplatError, type Splats, WORDS } from './splats.ts';

/**
 * The form of splats in a page: exactly what the GPU gets, so that a page shows what the preview shows. The bytes are sorted by their place
 * in a splat, which makes them compressible, and compressed by gzip.
 */
const MAGIC = 0x50534353;
const VERSION = 1;
const HEADER_BYTES = 32;

/** The ending of the form for pages. */
export const SPLAT_FILE_ENDING = '.splats';

/**
 * Writes splats as the content of a page's file, before its compression.
 *
 * @example
 * const bytes = gzipSync(writeSplatFile(splats));
 */
export function writeSplatFile({ count, degree, antialiased, words, harmonics, ranges }: Splats): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(HEADER_BYTES + words.byteLength + harmonics.byteLength);
  const view = new DataView(out.buffer);
  const numbers = [MAGIC, VERSION, count, degree, antialiased ? 1 : 0];
  for (const [i, value] of numbers.entries()) view.setUint32(4 * i, value, true);
  for (const [i, range] of ranges.entries()) view.setFloat32(20 + 4 * i, range, true);
  let at = HEADER_BYTES;
  for (const bytes of [bytesOf(words), bytesOf(harmonics)]) {
    const stride = bytes.length / count;
    for (let place = 0; place < stride; place++) for (let i = 0; i < count; i++) out[at++] = bytes[i * stride + place] ?? 0;
  }
  return out;
}

/**
 * Reads the splats of a page's file.
 *
 * @param packed The file.
 * @throws SplatError if it is damaged.
 *
 * @example
 * const splats = await readSplatFile(bytes);
 */
export async function readSplatFile(packed: Uint8Array<ArrayBuffer>): Promise<Splats> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  const content = await new Response(stream).arrayBuffer().catch(() => null);
  if (content === null || content.byteLength < HEADER_BYTES) throw new SplatError('it is damaged');
  const view = new DataView(content);
  const [magic, version, count = 0, degree = 0, antialiased] = [0, 4, 8, 12, 16].map((at) => view.getUint32(at, true));
  if (magic !== MAGIC || version !== VERSION || !isDegree(degree)) throw new SplatError('it is not a file of splats of this version');
  checkCount(count);
  const words = new Uint32Array(count * WORDS);
  const harmonics = new Uint32Array(count * HARMONICS_WORDS[degree]);
  if (content.byteLength !== HEADER_BYTES + words.byteLength + harmonics.byteLength) throw new SplatError('it is incomplete');
  const from = new Uint8Array(content);
  let at = HEADER_BYTES;
  for (const bytes of [bytesOf(words), bytesOf(harmonics)]) {
    const stride = bytes.length / count;
    for (let place = 0; place < stride; place++) for (let i = place; i < bytes.length; i += stride) bytes[i] = from[at++] ?? 0;
  }
  const range = (nth: number): number => view.getFloat32(20 + 4 * nth, true);
  return { count, degree, antialiased: antialiased === 1, words, harmonics, ranges: [range(0), range(1), range(2)], invalid: 0 };
}

function bytesOf(words: Uint32Array): Uint8Array {
  return new Uint8Array(words.buffer, words.byteOffset, words.byteLength);
}

function isDegree(degree: number): degree is Splats['degree'] {
  return degree <= 3;
}
