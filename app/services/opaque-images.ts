import { decode } from 'fast-png';
import type { Asset } from '../../export/graph/project.ts';
import { resolveInside } from './confine.ts';
import { isOpaqueVideo } from './opaque-videos.ts';
import { readBytes, readRange } from './read-file.ts';

/** Bytes in which the chunks before the pixels of a PNG file are looked for. */
const HEAD_BYTES = 65_536;
const PNG_SIGNATURE = '\x89PNG\r\n\x1a\n';
const PNG_COLOR_TYPE = 25;
const FIRST_CHUNK = 8;
/** Length and type of the first chunk, which files for iPhones alone put another one before. */
const PNG_HEADER = '\0\0\0\rIHDR';
/** Color types with an alpha channel (PNG specification, section 11.2.1). */
const WITH_ALPHA: readonly number[] = [4, 6];

/** The largest PNG file whose pixels are looked at, bytes. A larger one with an alpha channel counts as transparent. */
const MAX_DECODED_BYTES = 16 * 2 ** 20;
/** Where a WebP file names its first chunk, and the flags of an extended file (WebP Container Specification). */
const WEBP_CHUNK = 12;
const WEBP_FLAGS = 20;
const WEBP_ALPHA = 0x10;
/** Frames of an animation may leave parts of the image transparent, whatever they contain themselves. */
const WEBP_ANIMATION = 0x02;

/**
 * Finds the images and videos of a project that have no transparency: JPEG files, lossy still WebP files without alpha, and PNG files without alpha
 * channel and `tRNS` chunk, or with an alpha channel that is 1 in each pixel; videos as `isOpaqueVideo` says. A file that cannot be read is
 * not among them.
 *
 * @param root Folder of the project.
 * @returns Ids of the assets.
 */
export async function findOpaqueImages(root: string, assets: Readonly<Record<string, Asset>>): Promise<readonly string[]> {
  const found = await Promise.all(
    Object.entries(assets).map(async ([id, { kind, path }]) => {
      if (kind !== 'image' && kind !== 'video') return [];
      try {
        const file = await resolveInside(root, path);
        return (await (kind === 'image' ? isOpaque(file) : isOpaqueVideo(file))) ? [id] : [];
      } catch {
        // `checkAssets` reports it.
        return [];
      }
    }),
  );
  return found.flat();
}

async function isOpaque(path: string): Promise<boolean> {
  const head = await readRange(path, 0, HEAD_BYTES);
  if (head.length > 2 && head.readUInt16BE(0) === 0xffd8) return true;
  if (head.toString('latin1', 8, WEBP_CHUNK) === 'WEBP') return isOpaqueWebP(head);
  if (head.toString('latin1', 0, FIRST_CHUNK + 8) !== PNG_SIGNATURE + PNG_HEADER || head.length <= PNG_COLOR_TYPE) return false;
  return WITH_ALPHA.includes(head[PNG_COLOR_TYPE] ?? 0) ? hasOpaquePixels(path) : !hasTransparentColor(head);
}

function isOpaqueWebP(head: Buffer): boolean {
  const first = chunkAt(head, WEBP_CHUNK);
  if (first !== 'VP8X') return first === 'VP8 ';
  const flags = head[WEBP_FLAGS] ?? WEBP_ALPHA;
  if ((flags & (WEBP_ALPHA | WEBP_ANIMATION)) !== 0) return false;
  // Decoders show the alpha of a file that does not announce it.
  for (let at = WEBP_CHUNK; at + 8 <= head.length; at += 8 + 2 * Math.ceil(head.readUInt32LE(at + 4) / 2)) {
    if (chunkAt(head, at) === 'VP8 ') return true;
    if (chunkAt(head, at) === 'ALPH' || chunkAt(head, at) === 'VP8L') return false;
  }
  return false;
}

function chunkAt(head: Buffer, at: number): string {
  return head.toString('latin1', at, at + 4);
}

/** Whether the `tRNS` chunk of a PNG file comes before the pixels, or the pixels do not begin in what was read. */
function hasTransparentColor(head: Buffer): boolean {
  for (let at = FIRST_CHUNK; at + 8 <= head.length; at += 12 + head.readUInt32BE(at)) {
    const type = head.toString('latin1', at + 4, at + 8);
    if (type === 'tRNS') return true;
    if (type === 'IDAT') return false;
  }
  return true;
}

/** Whether the last channel of a PNG file is 1 in each pixel, as in files of programs that always write one. */
async function hasOpaquePixels(path: string): Promise<boolean> {
  const { data, channels, depth } = decode(await readBytes(path, MAX_DECODED_BYTES));
  const most = 2 ** depth - 1;
  for (let i = channels - 1; i < data.length; i += channels) if (data[i] !== most) return false;
  return true;
}
