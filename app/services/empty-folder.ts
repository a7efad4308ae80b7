import { readdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { realFolder } from './confine.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { makeFolders } from './make-folders.ts';

/**
 * Creates or uses an empty folder and fills it. Returns its real path. If `fill` fails, the folder is emptied again.
 *
 * @throws SCR060, SCR061 if it is not empty, SCR062
 */
export async function fillEmptyFolder(path: string, files: FileLayer, fill: (root: string) => Promise<void>): Promise<string> {
  const root = await emptyFolder(path);
  try {
    await fill(root);
  } catch (error) {
    // The folder was empty, so all files in it were created here.
    for (const name of await readdir(root)) await files.remove(join(root, name));
    throw writeRefusal(error, path);
  }
  return root;
}

async function emptyFolder(path: string): Promise<string> {
  const absolute = resolve(path);
  try {
    await makeFolders(absolute);
    const names = await readdir(absolute);
    if (names.length > 0) throw refusal('SCR061', `${path} is not empty. Nothing was written.`, 'Choose a new or an empty folder.');
  } catch (error) {
    throw writeRefusal(error, path);
  }
  return realFolder(absolute);
}
