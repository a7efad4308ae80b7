import { mkdir, stat } from 'node:fs/promises';
import { dirname } from 'node:path';
import { errorCode } from './file-errors.ts';

/**
 * Creates a folder and its missing parents. Returns the first created folder, if any. Rejects with system errors. Does not use
 * `recursive: true`, with which Node 20 loops forever if an existing folder rejects new entries with ENOENT, as `/proc` does.
 */
export async function makeFolders(path: string): Promise<string | undefined> {
  const missing: string[] = [];
  for (let folder = path; (await find(folder)) === null && dirname(folder) !== folder; folder = dirname(folder)) missing.unshift(folder);
  let firstMade: string | undefined;
  // If nothing is missing, tries `path` as well, so that the system reports if it is not a folder.
  for (const folder of missing.length === 0 ? [path] : missing) {
    const made = await makeFolder(folder);
    if (made) firstMade ??= folder;
  }
  return firstMade;
}

/** Returns false if the folder exists, possibly since a moment ago. */
async function makeFolder(path: string): Promise<boolean> {
  try {
    await mkdir(path);
    return true;
  } catch (error) {
    // The root of a drive gives EPERM, a read-only mount EROFS; both exist.
    if (errorCode(error) !== 'ENOENT' && (await find(path))?.isDirectory()) return false;
    throw error;
  }
}

function find(path: string) {
  return stat(path).catch(() => null);
}
