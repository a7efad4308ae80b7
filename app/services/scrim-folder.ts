import { randomBytes } from 'node:crypto';
import { lstat, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { resolveInside } from './confine.ts';
import { errorCode, refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { OWNER } from './owner.ts';

/** Folder of Scrim in a project: saves in progress and recovery files. Contains its own ignore file for version control. */
export const SCRIM_FOLDER = '.scrim';

/**
 * Creates the folder if it is missing.
 *
 * @throws SCR067 if the project folder is missing; it is not created, because it may have been moved or its drive removed
 */
export async function ensureScrimFolder(root: string, files: FileLayer): Promise<void> {
  await requireFolder(root);
  await files.makeFolder(await resolveInside(root, SCRIM_FOLDER));
  try {
    await files.writeNew(join(root, SCRIM_FOLDER, '.gitignore'), new TextEncoder().encode('*\n'));
  } catch (error) {
    if (errorCode(error) !== 'EEXIST') throw error;
  }
}

/**
 * Rejects if the project folder is missing.
 *
 * @throws SCR067
 */
export async function requireFolder(root: string): Promise<void> {
  const found = await lstat(root).catch((error: unknown) => {
    if (errorCode(error) === 'ENOENT' || errorCode(error) === 'ENOTDIR') return null;
    throw error;
  });
  if (found?.isDirectory()) return;
  throw refusal(
    'SCR067',
    `The project folder ${root} is missing: it was deleted, moved or renamed, or its drive is not connected. Nothing was saved.`,
    'Put the folder back and save again, or use “Save as” to save the project in another folder.',
  );
}

/**
 * Names of the files in the `.scrim` folder; empty if it is missing.
 *
 * @throws SCR031 if it is a link
 */
export async function listScrimFolder(root: string): Promise<readonly string[]> {
  return readdir(await resolveInside(root, SCRIM_FOLDER)).catch(() => []);
}

/** A unique path in the `.scrim` folder. The name contains the owner, so that the file can be removed after a crash. */
export function temporaryIn(root: string): string {
  return join(root, SCRIM_FOLDER, `temp-${OWNER}-${randomBytes(6).toString('hex')}`);
}
