import { createWriteStream } from 'node:fs';
import { lstat, readdir, readFile, readlink } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';
import { Readable } from 'node:stream';
import { pipeline } from 'node:stream/promises';
import { Zip, ZipPassThrough } from 'fflate';

/** Version made by: Unix, so that modes and links are kept (PKWARE APPNOTE 6.3.10, section 4.4.2). */
const UNIX = 3;
/** The first date that a ZIP can hold, so that equal folders give equal files. */
const DATE = new Date(1980, 0, 1);

/**
 * Writes a folder to a ZIP, stored without compression: the packager only takes Electron as a ZIP, and reads it once.
 *
 * @param target Path of the ZIP, below 4 GiB.
 * @param skip Leaves out a file by its path in the folder.
 */
export async function zipFolder(folder: string, target: string, skip: (path: string) => boolean = () => false): Promise<void> {
  await pipeline(Readable.from(zipParts(folder, skip)), createWriteStream(target));
}

async function* zipParts(folder: string, skip: (path: string) => boolean): AsyncGenerator<Uint8Array> {
  const parts: Uint8Array[] = [];
  const zip = new Zip((error, part) => {
    if (error) throw error;
    parts.push(part);
  });
  for (const path of await listPaths(folder)) {
    if (skip(path)) continue;
    const { mode, bytes } = await readEntry(join(folder, path));
    const file = Object.assign(new ZipPassThrough(path), { os: UNIX, attrs: (mode << 16) >>> 0, mtime: DATE });
    zip.add(file);
    file.push(bytes, true);
    yield* parts.splice(0);
  }
  zip.end();
  yield* parts;
}

async function listPaths(folder: string): Promise<readonly string[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => !entry.isDirectory())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .sort();
}

async function readEntry(path: string): Promise<{ mode: number; bytes: Buffer }> {
  const found = await lstat(path);
  return { mode: found.mode, bytes: found.isSymbolicLink() ? Buffer.from(await readlink(path)) : await readFile(path) };
}
