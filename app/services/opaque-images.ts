import type { Asset } from '../../export/graph/project.ts';
import { resolveInside } from './confine.ts';
import { openFile } from './read-file.ts';

/** Bytes in which the chunks before the pixels of a PNG file are looked for. */
const HEAD_BYTES = 65_536;
const PNG_SIGNATURE = '\x89PNG\r\n\x1a\n';
const PNG_COLOR_TYPE = 25;
const FIRST_CHUNK = 8;
/** Color types with an alpha channel (PNG specification, section 11.2.1). */
const WITH_ALPHA: readonly number[] = [4, 6];

/**
 * Finds the images of a project that have no transparency: JPEG files, and PNG files without alpha channel and `tRNS` chunk. An image that
 * cannot be read is not among them.
 *
 * @param root Folder of the project.
 * @returns Ids of the assets.
 */
export async function findOpaqueImages(root: string, assets: Readonly<Record<string, Asset>>): Promise<readonly string[]> {
  const found = await Promise.all(
    Object.entries(assets).map(async ([id, { kind, path }]) => {
      if (kind !== 'image') return [];
      try {
        return isOpaque(await readHead(await resolveInside(root, path))) ? [id] : [];
      } catch {
        // `checkAssets` reports it.
        return [];
      }
    }),
  );
  return found.flat();
}

async function readHead(path: string): Promise<Buffer> {
  const file = await openFile(path);
  try {
    const head = Buffer.alloc(HEAD_BYTES);
    const { bytesRead } = await file.read(head, 0, HEAD_BYTES, 0);
    return head.subarray(0, bytesRead);
  } finally {
    await file.close();
  }
}

function isOpaque(head: Buffer): boolean {
  if (head.length > 2 && head.readUInt16BE(0) === 0xffd8) return true;
  if (head.toString('latin1', 0, FIRST_CHUNK) !== PNG_SIGNATURE) return false;
  if (head.length <= PNG_COLOR_TYPE || WITH_ALPHA.includes(head[PNG_COLOR_TYPE] ?? 0)) return false;
  for (let at = FIRST_CHUNK; at + 8 <= head.length; at += 12 + head.readUInt32BE(at)) {
    const type = head.toString('latin1', at + 4, at + 8);
    if (type === 'tRNS') return false;
    if (type === 'IDAT') return true;
  }
  return false;
}
