import { rmSync } from 'node:fs';
import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER, OWNER_PATTERN } from './owner.ts';
import { ensureScrimFolder, listScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

/*
 * A window leaves a sign in the projects that it shows, so that one of another process can tell its person of it. Signs are a
 * courtesy: where none can be written, projects open all the same.
 */

const SIGN = new RegExp(`^window-(${OWNER_PATTERN})-[0-9a-f]+$`);

export async function leaveSign(root: string, projectId: string, files: FileLayer): Promise<void> {
  try {
    await ensureScrimFolder(root, files);
    await files.writeNew(signOf(root, projectId), new Uint8Array());
  } catch {
    // Read-only, full, or gone.
  }
}

/** At once, because a process that ends waits for nothing. */
export function takeSignAway(root: string, projectId: string): void {
  try {
    rmSync(signOf(root, projectId), { force: true });
  } catch {
    // It is swept up when its process is gone.
  }
}

/** Whether another process that is alive shows the project. */
export async function isShownByOthers(root: string): Promise<boolean> {
  for (const name of await listScrimFolder(root)) {
    const owner = SIGN.exec(name)?.[1];
    if (owner === undefined || owner === OWNER) continue;
    const found = await lstat(join(root, SCRIM_FOLDER, name)).catch(() => null);
    if (found && !isGone(owner, found.mtimeMs)) return true;
  }
  return false;
}

function signOf(root: string, projectId: string): string {
  return join(root, SCRIM_FOLDER, `window-${OWNER}-${projectId}`);
}
