import { readFile, stat } from 'node:fs/promises';
import { MAX_COPIED_BYTES } from '../contract/contract.ts';
import { resolveInside } from './confine.ts';
import { errorCode, readRefusal, refusal } from './file-errors.ts';
import { ASSETS_FOLDER } from './project-files.ts';

/** The bytes of a file below `assets/`. Throws SCR031 for anything else and SCR005 for what is too large to be copied as text. */
export async function readAsset(root: string, path: string): Promise<Uint8Array> {
  if (!path.startsWith(`${ASSETS_FOLDER}/`)) throw refusal('SCR031', `${path} is no asset of the project.`);
  const file = await resolveInside(root, path);
  try {
    const { size } = await stat(file);
    if (size > MAX_COPIED_BYTES) throw refusal('SCR005', `${path} is too large to be copied to another project.`);
    return await readFile(file);
  } catch (error) {
    throw errorCode(error) === undefined ? error : readRefusal(error, path);
  }
}
