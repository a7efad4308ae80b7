import { randomBytes } from 'node:crypto';
import { lstat, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { resolveInside } from './confine.ts';
import { errorCode, refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { OWNER } from './owner.ts';

/** Scrim's own folder in a project: saves in progress and unsaved work. It keeps itself out of version control. */
export const SCRIM_FOLDER = '.scrim';

/** Throws SCR067 where the project's own folder is gone. It is not created again: it may have been moved, or be on a removed drive. */
export async function ensureScrimFolder(root: string, files: FileLayer): Promise<void> {
  await requireFolder(root);
  await files.makeFolder(await resolveInside(root, SCRIM_FOLDER));
  try {
    await files.writeNew(join(root, SCRIM_FOLDER, '.gitignore'), new TextEncoder().encode('*\n'));
  } catch (error) {
    if (errorCode(error) !== 'EEXIST') throw error;
  }
}

/** Throws SCR067. */
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

/** What is in Scrim's folder; nothing where there is none. Throws SCR031 where that is a link. */
export async function listScrimFolder(root: string): Promise<readonly string[]> {
  return readdir(await resolveInside(root, SCRIM_FOLDER)).catch(() => []);
}

/** A path in Scrim's folder that nobody has, signed, so that it is swept up if the process dies. */
export function temporaryIn(root: string): string {
  return join(root, SCRIM_FOLDER, `temp-${OWNER}-${randomBytes(6).toString('hex')}`);
}
