import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import type { ProjectFiles } from '../contract/contract.ts';
import { errorCode, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER_PATTERN } from './owner.ts';
import { readProjectFiles, revisionOf } from './project-files.ts';
import { isLocked, LOCK_NAME, withLock } from './project-lock.ts';
import { listScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';
import { finishInterrupted, JOURNAL_NAME } from './transaction.ts';

const STAGING = /^save-[0-9a-f]{12}$/;
const SIGNED = new RegExp(`^(?:temp|window)-(${OWNER_PATTERN})-[0-9a-f]+$`);

/**
 * Makes a project's folder whole before it is read: waits for a save that is under way in another window, ends one whose process
 * has died, and sweeps up what such processes left. Throws SCR060 and SCR062 where a half-done save cannot be ended.
 */
export async function settleFolder(root: string, files: FileLayer): Promise<void> {
  const names = await listScrimFolder(root);
  const left = await leftBehind(root, names);
  if (left.length === 0 && !names.includes(LOCK_NAME) && !names.includes(JOURNAL_NAME)) return;
  try {
    await withLock(root, files, async () => {
      await finishInterrupted(root, files);
      for (const name of await leftBehind(root, await listScrimFolder(root))) await files.remove(join(root, SCRIM_FOLDER, name));
    });
  } catch (error) {
    // Rubbish that cannot be swept up is no reason to refuse a project that is whole.
    if (!names.includes(JOURNAL_NAME) && errorCode(error) !== undefined) return;
    throw writeRefusal(error, root);
  }
}

/** More than any two saves in a row leave room between; a folder that never rests is read as it comes. */
const MAX_READS = 50;

/**
 * The texts of a project, all of one version, whoever saves it meanwhile. Nobody locks for reading, because a folder may be
 * read-only: a read counts when no save was under way after it, and a second one finds the same.
 */
export async function readSettled(root: string, files: FileLayer): Promise<ProjectFiles> {
  for (let reads = 1; ; reads++) {
    await settleFolder(root, files);
    const texts = await readProjectFiles(root);
    const resting = !(await isLocked(root)) && revisionOf(await readProjectFiles(root)) === revisionOf(texts);
    if (resting || reads === MAX_READS) return texts;
  }
}

/** Only who holds the lock has a staging folder, so one that is seen by the next holder belongs to nobody. */
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
