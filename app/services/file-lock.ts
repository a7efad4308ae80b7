import { lstat } from 'node:fs/promises';
import { errorCode } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { readText } from './read-file.ts';

/** Where a lock is: the process that creates the file holds it. */
export interface LockPlace {
  readonly path: string;
  /** A new path in the same folder. */
  readonly temporary: () => string;
}

export interface SeenLock {
  /** Content of the lock file; null if the file is not a lock: a pipe, a link, a folder, or too long. */
  readonly text: string | null;
  readonly touchedMs: number;
}

/** Maximum length of a signature, the content of a lock. Longer files are not locks. */
const MAX_SIGNATURE_BYTES = 1024;

/**
 * Creates the lock by a hard link, so that it never exists without its owner. Falls back to a plain file on FAT, which has no links.
 *
 * @returns Whether the lock is taken; false if there is one.
 */
export async function tryToTake({ path, temporary }: LockPlace, files: FileLayer, signature: string): Promise<boolean> {
  const bytes = new TextEncoder().encode(signature);
  const made = temporary();
  try {
    await files.writeNew(made, bytes);
    await files.link(made, path).catch(async (error: unknown) => {
      if (errorCode(error) === 'EEXIST') throw error;
      await files.writeNew(path, bytes);
    });
    return true;
  } catch (error) {
    if (errorCode(error) === 'EEXIST') return false;
    throw error;
  } finally {
    await files.remove(made).catch(() => {});
  }
}

/**
 * Removes the lock if it is abandoned.
 *
 * @returns The lock that is there; null if there may be none now.
 */
export async function breakIfLeft(
  { path, temporary }: LockPlace,
  files: FileLayer,
  isLeft: (held: SeenLock) => boolean | Promise<boolean>,
): Promise<SeenLock | null> {
  const held = await readLock(path);
  if (held === null) return null;
  if (!(await isLeft(held))) return held;
  const aside = temporary();
  try {
    await files.rename(path, aside);
  } catch (error) {
    if (errorCode(error) === 'ENOENT') return null;
    throw error;
  }
  // Another process may have broken and taken the lock before the rename. Then its lock is restored.
  if ((await readLock(aside))?.text !== held.text) await files.link(aside, path).catch(() => {});
  await files.remove(aside);
  return null;
}

/** Reads a lock; null if there is none. */
export async function readLock(path: string): Promise<SeenLock | null> {
  const found = await lstat(path).catch(() => null);
  if (found === null) return null;
  const text = await readText(path, MAX_SIGNATURE_BYTES).catch((error: unknown) => {
    if (errorCode(error) === 'ENOENT') return undefined;
    return null;
  });
  return text === undefined ? null : { text, touchedMs: found.mtimeMs };
}
