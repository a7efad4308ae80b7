import { extname } from 'node:path';
import { resolveInside } from './confine.ts';
import { errorCode, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { ASSETS_FOLDER } from './project-files.ts';
import { readBytes } from './read-file.ts';
import { ensureScrimFolder, temporaryIn } from './scrim-folder.ts';

const MAX_STEM = 80;

/** Reserved device names of Windows, with any extension. */
const DEVICE_NAME = /^(con|prn|aux|nul|com\d|lpt\d)$/i;

/**
 * Writes bytes into `assets/` and returns the project path. If the name exists, a number is added, unless the existing file has the
 * same content and is reused.
 */
export async function importAsset(root: string, name: string, bytes: Uint8Array, files: FileLayer): Promise<string> {
  const { stem, extension } = plainName(name);
  try {
    await files.makeFolder(await resolveInside(root, ASSETS_FOLDER));
    await ensureScrimFolder(root, files);
    const temporary = temporaryIn(root);
    try {
      await files.writeNew(temporary, bytes);
      for (let number = 1; ; number++) {
        const path = `${ASSETS_FOLDER}/${stem}${number === 1 ? '' : `-${number}`}${extension}`;
        if (await place(temporary, await resolveInside(root, path), bytes, files)) return path;
      }
    } finally {
      await files.remove(temporary);
    }
  } catch (error) {
    throw writeRefusal(error, `${root}/${ASSETS_FOLDER}`);
  }
}

/** Puts the file in place. Returns false if another file has the name. */
async function place(temporary: string, target: string, bytes: Uint8Array, files: FileLayer): Promise<boolean> {
  try {
    await files.link(temporary, target).catch(async (error: unknown) => {
      if (errorCode(error) === 'EEXIST') throw error;
      // FAT does not support links.
      await files.writeNew(target, bytes);
    });
    return true;
  } catch (error) {
    if (errorCode(error) !== 'EEXIST') throw error;
    return Buffer.from(bytes).equals(await readBytes(target, bytes.length).catch(() => Buffer.alloc(0)));
  }
}

/** Makes a file name that is valid on all systems and in URLs. */
function plainName(name: string): { stem: string; extension: string } {
  const base = name.split(/[\\/]/).pop() ?? '';
  const extension = extname(base).replace(/[^A-Za-z0-9.]/g, '');
  const stem = base
    .slice(0, base.length - extname(base).length)
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^A-Za-z0-9_-]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, MAX_STEM);
  const safe = stem === '' || DEVICE_NAME.test(stem) ? `asset-${stem}`.replace(/-$/, '') : stem;
  return { stem: safe, extension: extension.toLowerCase() };
}
