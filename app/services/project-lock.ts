import { lstat, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { errorCode, refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER } from './owner.ts';
import { ensureScrimFolder, SCRIM_FOLDER, temporaryIn } from './scrim-folder.ts';

/** Whoever has this file is the one who writes the project, among all windows and processes. It holds its owner's signature. */
export const LOCK_NAME = 'lock';

const POLL_MS = 20;
/** A save takes milliseconds; a disk that has to wake up takes seconds. */
const PATIENCE_MS = 15_000;

/** Does `task` while nobody else writes the project. What a process that died has locked is open. Throws SCR060. */
export async function withLock<T>(root: string, files: FileLayer, task: () => Promise<T>): Promise<T> {
  await ensureScrimFolder(root, files);
  await acquire(root, files);
  try {
    return await task();
  } finally {
    await files.remove(lockOf(root)).catch(() => {});
  }
}

/** Whether somebody who is alive writes the project at this moment. */
export async function isLocked(root: string): Promise<boolean> {
  const held = await readLock(root);
  return held !== null && !isGone(held.owner, held.touchedMs);
}

async function acquire(root: string, files: FileLayer): Promise<void> {
  const startMs = Date.now();
  while (!(await tryToTake(root, files))) {
    if (await breakIfLeft(root, files)) continue;
    if (Date.now() - startMs > PATIENCE_MS) {
      throw refusal('SCR060', 'Another Scrim is writing this project and does not come to an end. Nothing was changed.', 'Try again.');
    }
    await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  }
}

/** By a link, so that the lock is never seen without its owner; FAT has no links. */
async function tryToTake(root: string, files: FileLayer): Promise<boolean> {
  const signature = new TextEncoder().encode(OWNER);
  const temporary = temporaryIn(root);
  try {
    await files.writeNew(temporary, signature);
    await files.link(temporary, lockOf(root)).catch(async (error: unknown) => {
      if (errorCode(error) === 'EEXIST') throw error;
      await files.writeNew(lockOf(root), signature);
    });
    return true;
  } catch (error) {
    if (errorCode(error) === 'EEXIST') return false;
    throw error;
  } finally {
    await files.remove(temporary).catch(() => {});
  }
}

/** Takes away the lock of a process that has ended; true where there may be none any more. */
async function breakIfLeft(root: string, files: FileLayer): Promise<boolean> {
  const held = await readLock(root);
  if (held === null) return true;
  if (!isGone(held.owner, held.touchedMs)) return false;
  const aside = temporaryIn(root);
  try {
    await files.rename(lockOf(root), aside);
  } catch (error) {
    if (errorCode(error) === 'ENOENT') return true;
    throw error;
  }
  // Somebody else may have broken it, and locked, between the look and the rename: then it is theirs, and goes back.
  if ((await readFile(aside, 'utf8')) !== held.owner) await files.link(aside, lockOf(root)).catch(() => {});
  await files.remove(aside);
  return true;
}

async function readLock(root: string): Promise<{ readonly owner: string; readonly touchedMs: number } | null> {
  try {
    return { owner: await readFile(lockOf(root), 'utf8'), touchedMs: (await lstat(lockOf(root))).mtimeMs };
  } catch {
    return null;
  }
}

function lockOf(root: string): string {
  return join(root, SCRIM_FOLDER, LOCK_NAME);
}
