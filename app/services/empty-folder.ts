import { readdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { realFolder } from './confine.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { makeFolders } from './make-folders.ts';

/**
 * Fills the folder at `path`, made where it is missing, and answers with where it really lies. Where `fill` fails, the folder is
 * empty again. Throws SCR061 where it holds something, and SCR060 and SCR062.
 */
export async function fillEmptyFolder(path: string, files: FileLayer, fill: (root: string) => Promise<void>): Promise<string> {
  const root = await emptyFolder(path);
  try {
    await fill(root);
  } catch (error) {
    // The folder was empty: whatever is in it is ours.
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
