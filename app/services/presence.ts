import { rmSync } from 'node:fs';
import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER, OWNER_PATTERN } from './owner.ts';
import { ensureScrimFolder, listScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

/*
 * Each window writes a sign file to the projects that it shows, so that other processes can warn about it. If it cannot be written,
 * the project opens anyway.
 */

const SIGN = new RegExp(`^window-(${OWNER_PATTERN})-[0-9a-f]+$`);

export async function leaveSign(root: string, projectId: string, files: FileLayer): Promise<void> {
  try {
    await ensureScrimFolder(root, files);
    await files.writeNew(signOf(root, projectId), new Uint8Array());
  } catch {
    // The folder is read-only, full or missing.
  }
}

/** Deletes the sign file of a window. Synchronous, because a process that exits does not wait. */
export function removeSign(root: string, projectId: string): void {
  try {
    rmSync(signOf(root, projectId), { force: true });
  } catch {
    // The sign is removed when its process has ended.
  }
}

/** Whether another running process shows the project. */
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
