import { randomBytes } from 'node:crypto';
import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { resolveInside } from './confine.ts';
import { errorCode } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { OWNER } from './owner.ts';

/** Scrim's own folder in a project: saves in progress and unsaved work. It keeps itself out of version control. */
export const SCRIM_FOLDER = '.scrim';

export async function ensureScrimFolder(root: string, files: FileLayer): Promise<void> {
  await files.makeFolder(await resolveInside(root, SCRIM_FOLDER));
  try {
    await files.writeNew(join(root, SCRIM_FOLDER, '.gitignore'), new TextEncoder().encode('*\n'));
  } catch (error) {
    if (errorCode(error) !== 'EEXIST') throw error;
  }
}

/** What is in Scrim's folder; nothing where there is none. Throws SCR031 where that is a link. */
export async function listScrimFolder(root: string): Promise<readonly string[]> {
  return readdir(await resolveInside(root, SCRIM_FOLDER)).catch(() => []);
}

/** A path in Scrim's folder that nobody has, signed, so that it is swept up if the process dies. */
export function temporaryIn(root: string): string {
  return join(root, SCRIM_FOLDER, `temp-${OWNER}-${randomBytes(6).toString('hex')}`);
}
