import { mkdir, stat } from 'node:fs/promises';
import { dirname } from 'node:path';
import { errorCode } from './file-errors.ts';

/**
 * Makes the folder at the absolute `path` and those above it that are missing; answers with the first that it made, if any. Rejects
 * with the system's error. Not `recursive: true`: Node 20 then tries for ever where a folder that is there refuses every new name
 * with ENOENT, as `/proc` does.
 */
export async function makeFolders(path: string): Promise<string | undefined> {
  const missing: string[] = [];
  for (let folder = path; (await find(folder)) === null && dirname(folder) !== folder; folder = dirname(folder)) missing.unshift(folder);
  let firstMade: string | undefined;
  // Where nothing is missing, `path` is tried as well: the system reports it if it is not a folder.
  for (const folder of missing.length === 0 ? [path] : missing) {
    const made = await makeFolder(folder);
    if (made) firstMade ??= folder;
  }
  return firstMade;
}

/** False where it is there, perhaps since a moment. */
async function makeFolder(path: string): Promise<boolean> {
  try {
    await mkdir(path);
    return true;
  } catch (error) {
    // A drive's root says EPERM, a mounted folder EROFS: it is there all the same.
    if (errorCode(error) !== 'ENOENT' && (await find(path))?.isDirectory()) return false;
    throw error;
  }
}

function find(path: string) {
  return stat(path).catch(() => null);
}
