import { MAX_ASSET_BYTES } from '../contract/call-parts.ts';
import { MAX_COPIED_BYTES } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { resolveInside } from './confine.ts';
import { errorCode, readRefusal, refusal } from './file-errors.ts';
import { ASSETS_FOLDER } from './project-files.ts';
import { NotAFileError, readBytes, TooLargeError } from './read-file.ts';

/** Reads a file that a program uses. Rejects with an `Error` whose text contains no path of this machine. */
export async function readAssetFile(root: string, path: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return await readBytes(await resolveInside(root, path), MAX_ASSET_BYTES);
  } catch (error) {
    if (error instanceof HostError) throw new Error(error.diagnostic.message);
    if (error instanceof NotAFileError) throw new Error(`it is ${error.what}, not a file`);
    if (error instanceof TooLargeError) throw new Error(`it has more than ${MAX_ASSET_BYTES / 2 ** 20} MB`);
    throw new Error(errorCode(error) === 'ENOENT' ? 'there is no such file' : (errorCode(error) ?? String(error)));
  }
}

/**
 * Reads a file in `assets/`.
 *
 * @throws SCR031 for other paths, SCR005 if it is too large to copy as text
 */
export async function readAsset(root: string, path: string): Promise<Uint8Array> {
  if (!path.startsWith(`${ASSETS_FOLDER}/`)) throw refusal('SCR031', `${path} is not an asset of the project.`);
  const file = await resolveInside(root, path);
  try {
    return await readBytes(file, MAX_COPIED_BYTES);
  } catch (error) {
    if (error instanceof TooLargeError) throw refusal('SCR005', `${path} is too large to be copied to another project.`);
    throw errorCode(error) === undefined ? error : readRefusal(error, path);
  }
}
