import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import type { ProjectFiles } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { errorCode, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER_PATTERN } from './owner.ts';
import { readProjectFiles, revisionOf } from './project-files.ts';
import { isLocked, LOCK_NAME, OPEN_PATIENCE_MS, withLock } from './project-lock.ts';
import { listScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';
import { finishInterrupted, JOURNAL_NAME } from './transaction.ts';

const STAGING = /^save-[0-9a-f]{12}$/;
const SIGNED = new RegExp(`^(?:temp|window)-(${OWNER_PATTERN})-[0-9a-f]+$`);

/**
 * Recovers a project folder before it is read: waits for a save in another window, completes a save whose process died, and
 * removes the temporary files of ended processes. Returns false if the other save did not end in time. Throws SCR060 and SCR062 if an
 * interrupted save cannot be completed.
 */
export async function recoverFolder(root: string, files: FileLayer): Promise<boolean> {
  const names = await listScrimFolder(root);
  const left = await leftBehind(root, names);
  if (left.length === 0 && !names.includes(LOCK_NAME) && !names.includes(JOURNAL_NAME)) return true;
  try {
    await withLock(
      root,
      files,
      async () => {
        await finishInterrupted(root, files);
        for (const name of await leftBehind(root, await listScrimFolder(root))) await files.remove(join(root, SCRIM_FOLDER, name));
      },
      { patienceMs: OPEN_PATIENCE_MS },
    );
  } catch (error) {
    // Reading needs no lock, so the project opens. The next save reports the lock.
    if (error instanceof HostError && error.diagnostic.code === 'SCR066') return false;
    // Failures to clean up do not prevent opening a valid project.
    if (!names.includes(JOURNAL_NAME) && errorCode(error) !== undefined) return true;
    throw writeRefusal(error, root);
  }
  return true;
}

/** Maximum number of attempts. A folder that changes continuously is then used as read. */
const MAX_READS = 50;

/**
 * Reads all texts of a project in the same version, also while another process saves. Reading takes no lock, because the folder may
 * be read-only. A read is valid if no save was in progress after it and a second read is equal.
 */
export async function readConsistentFiles(root: string, files: FileLayer): Promise<ProjectFiles> {
  for (let reads = 1; ; reads++) {
    const settled = await recoverFolder(root, files);
    const texts = await readProjectFiles(root);
    if (!settled) return texts;
    const resting = !(await isLocked(root, files)) && revisionOf(await readProjectFiles(root)) === revisionOf(texts);
    if (resting || reads === MAX_READS) return texts;
  }
}

/** Staging folders of earlier saves. Only the holder of the lock has one, so the next holder may delete all others. */
async function leftBehind(root: string, names: readonly string[]): Promise<readonly string[]> {
  const left: string[] = [];
  for (const name of names) {
    const owner = SIGNED.exec(name)?.[1];
    if (STAGING.test(name)) left.push(name);
    else if (owner !== undefined) {
      const found = await lstat(join(root, SCRIM_FOLDER, name)).catch(() => null);
      if (found && isGone(owner, found.mtimeMs)) left.push(name);
    }
  }
  return left;
}
