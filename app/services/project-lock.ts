import { randomBytes } from 'node:crypto';
import { constants } from 'node:fs';
import { lstat, open } from 'node:fs/promises';
import { join } from 'node:path';
import type { HostError } from '../contract/host-error.ts';
import { refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { breakIfLeft, type LockPlace, readLock, type SeenLock, tryToTake } from './file-lock.ts';
import { hasEnded, OWNER } from './owner.ts';
import { ensureScrimFolder, SCRIM_FOLDER, temporaryIn } from './scrim-folder.ts';

/**
 * Name of the lock file. The process that creates the file may write the project. The file contains the owner and a random number, because
 * a process may lock repeatedly.
 */
export const LOCK_NAME = 'lock';

const POLL_MS = 20;
/** A save waits this long for a lock. Saves take milliseconds; a disk that wakes up takes seconds. */
const SAVE_PATIENCE_MS = 15_000;
/** Opening waits this long, and then continues without the lock. */
export const OPEN_PATIENCE_MS = 3_000;

/** Interval at which the holder touches the lock. */
const TOUCH_MS = 5_000;
/** A lock that was not touched for this time is abandoned: its machine sleeps, or its process cannot be checked. */
const LEFT_MS = 60_000;

/** A lock that is held while the task runs. */
export interface HeldLock {
  /** Rejects with SCR066 if the lock was broken. Nothing more may be written then. */
  stillMine(): Promise<void>;
}

export interface LockOptions {
  readonly patienceMs?: number;
}

/**
 * Runs `task` while holding the lock. Breaks an abandoned lock.
 *
 * @throws SCR060, SCR066, SCR067
 */
export async function withLock<T>(
  root: string,
  files: FileLayer,
  task: (lock: HeldLock) => Promise<T>,
  { patienceMs = SAVE_PATIENCE_MS }: LockOptions = {},
): Promise<T> {
  await ensureScrimFolder(root, files);
  const signature = `${OWNER} ${randomBytes(8).toString('hex')}`;
  await acquire(root, files, signature, patienceMs);
  const touching = setInterval(() => void touch(root, signature).catch(() => {}), TOUCH_MS);
  const isMine = async () => (await readLock(lockOf(root)))?.text === signature;
  try {
    return await task({
      stillMine: async () => {
        if (!(await isMine()))
          throw refusal('SCR066', 'Another Scrim took over this project during the save. Nothing was saved.', 'Save again.');
      },
    });
  } finally {
    clearInterval(touching);
    if (await isMine()) await files.remove(lockOf(root)).catch(() => {});
  }
}

/** Whether another process is writing the project. */
export async function isLocked(root: string, files: FileLayer): Promise<boolean> {
  const held = await readLock(lockOf(root));
  return held !== null && !(await isLeft(root, held, files));
}

/** Removes any lock, at the user’s request. The holder notices it before it writes. */
export async function breakLock(root: string, files: FileLayer): Promise<void> {
  await files.remove(lockOf(root));
}

async function acquire(root: string, files: FileLayer, signature: string, patienceMs: number): Promise<void> {
  const startMs = Date.now();
  const place = placeOf(root);
  while (!(await tryToTake(place, files, signature))) {
    if ((await breakIfLeft(place, files, (held) => isLeft(root, held, files))) === null) continue;
    if (Date.now() - startMs > patienceMs) throw locked();
    await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  }
}

function locked(): HostError {
  return refusal(
    'SCR066',
    'Another Scrim is still writing this project. Nothing was saved.',
    'Try again in a minute. If you know that nobody else has the project open, break its lock.',
  );
}

/**
 * Rewrites the signature, so that the file system updates the modification time of the lock, which `isLeft` compares with that of a probe
 * file. Does not touch the lock of another process.
 */
async function touch(root: string, signature: string): Promise<void> {
  const file = await open(lockOf(root), constants.O_RDWR | (constants.O_NOFOLLOW ?? 0) | (constants.O_NONBLOCK ?? 0));
  try {
    if (!(await file.stat()).isFile() || (await file.readFile('utf8')) !== signature) return;
    await file.write(signature, 0);
    await file.sync();
  } finally {
    await file.close();
  }
}

/**
 * Whether a lock is abandoned: its process has ended, or its modification time differs by `LEFT_MS` or more, in either direction, from that
 * of a new probe file. If no probe can be written, from the clock of this machine. Files that are not locks are abandoned.
 */
async function isLeft(root: string, { text, touchedMs }: SeenLock, files: FileLayer): Promise<boolean> {
  if (text === null || hasEnded(text.split(' ')[0] ?? '')) return true;
  const probe = temporaryIn(root);
  try {
    await files.writeNew(probe, new Uint8Array());
    return Math.abs((await lstat(probe)).mtimeMs - touchedMs) >= LEFT_MS;
  } catch {
    return Math.abs(Date.now() - touchedMs) >= LEFT_MS;
  } finally {
    await files.remove(probe).catch(() => {});
  }
}

/** The lock of a project. */
function placeOf(root: string): LockPlace {
  return { path: lockOf(root), temporary: () => temporaryIn(root) };
}

function lockOf(root: string): string {
  return join(root, SCRIM_FOLDER, LOCK_NAME);
}
