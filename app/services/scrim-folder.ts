import { randomBytes } from 'node:crypto';
import { lstat, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { resolveInside } from './confine.ts';
import { errorCode } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';

/** Scrim's own folder in a project: saves in progress and unsaved work. It keeps itself out of version control. */
export const SCRIM_FOLDER = '.scrim';

/** What is younger may belong to another window's save. */
const RUBBISH_AGE_MS = 24 * 3600 * 1000;

export async function ensureScrimFolder(root: string, files: FileLayer): Promise<void> {
  await files.makeFolder(await resolveInside(root, SCRIM_FOLDER));
  try {
    await files.writeNew(join(root, SCRIM_FOLDER, '.gitignore'), new TextEncoder().encode('*\n'));
  } catch (error) {
    if (errorCode(error) !== 'EEXIST') throw error;
  }
}

/** A path in Scrim's folder that nobody has: of a kind that is swept up if the process dies. */
export function temporaryIn(root: string, kind: 'asset' | 'unsaved'): string {
  return join(root, SCRIM_FOLDER, `${kind}-${randomBytes(6).toString('hex')}`);
}

/** Removes what processes that died left: staging folders and half-written files. */
export async function sweepScrimFolder(root: string, files: FileLayer): Promise<void> {
  const folder = await resolveInside(root, SCRIM_FOLDER);
  for (const name of await readdir(folder).catch(() => [])) {
    if (!/^(save|asset|unsaved)-[0-9a-f]{12}$/.test(name)) continue;
    const found = await lstat(join(folder, name)).catch(() => null);
    if (found && Date.now() - found.mtimeMs > RUBBISH_AGE_MS) await files.remove(join(folder, name));
  }
}
