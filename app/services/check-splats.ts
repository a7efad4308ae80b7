import type { FileHandle } from 'node:fs/promises';
import { openSog } from '../../nodes/kit/splats/sog-archive.ts';
import { MAX_PLY_HEADER_BYTES, readSplatPlyHeader } from '../../nodes/kit/splats/splat-ply.ts';
import { SPLAT_LIMITS } from '../../nodes/kit/splats/splats.ts';

/**
 * Counts the splats of a PLY or SOG file, of which it checks the header and the files.
 *
 * @param size The size of the file, bytes.
 * @throws SplatError if they cannot be shown.
 */
export async function countSplats(file: FileHandle, path: string, size: number): Promise<number> {
  if (!path.toLowerCase().endsWith('.sog')) {
    const head = new Uint8Array(Math.min(size, MAX_PLY_HEADER_BYTES));
    await file.read(head, 0, head.length, 0);
    return readSplatPlyHeader(head, size).count;
  }
  // A file is read from where it was read last.
  const bytes = new Uint8Array(size);
  await file.read(bytes, 0, size, 0);
  return (await openSog(bytes)).meta.count;
}

/** The warning about many splats, without the path; null if there are few enough for all devices. */
export function manySplats(count: number): { readonly message: string; readonly fix: string } | null {
  const { phone, headset } = SPLAT_LIMITS;
  if (count <= headset) return null;
  const [limit, devices] = count > phone ? [phone, 'phones and headsets'] : [headset, 'headsets'];
  const message = `has ${count} splats; pages with more than ${limit} are slow on ${devices}.`;
  return { message, fix: 'Remove splats in an editor for splats.' };
}
