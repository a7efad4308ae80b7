import { randomBytes } from 'node:crypto';
import { constants } from 'node:fs';
import { lstat, open } from 'node:fs/promises';
import { join } from 'node:path';
import type { HostError } from '../contract/host-error.ts';
import { errorCode, refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { hasEnded, OWNER } from './owner.ts';
import { readText } from './read-file.ts';
import { ensureScrimFolder, SCRIM_FOLDER, temporaryIn } from './scrim-folder.ts';

/**
 * The process that creates this file may write the project. The file holds the owner's signature and a random number, because one
 * process may lock many times.
 */
export const LOCK_NAME = 'lock';

const POLL_MS = 20;
/** A save takes milliseconds; a disk that has to wake up takes seconds. */
const SAVE_PATIENCE_MS = 15_000;
/** A project is opened all the same. */
export const OPEN_PATIENCE_MS = 3_000;

/** How often the holder says that it is still there. */
const TOUCH_MS = 5_000;
/** A lock that was not touched for this long is abandoned: its machine went to sleep, or its process cannot be checked from here. */
const LEFT_MS = 60_000;

/** More than any signature; what is longer is none. */
const MAX_SIGNATURE_BYTES = 1024;

/** A lock that is held, for as long as the task runs. */
export interface HeldLock {
  /** Rejects with SCR066 where somebody has broken it: then nothing more may be written. */
  stillMine(): Promise<void>;
}

export interface LockOptions {
  readonly patienceMs?: number;
}

/** Runs `task` while no other process writes the project. Breaks an abandoned lock. Throws SCR060, SCR066 and SCR067. */
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
  const isMine = async () => (await readLock(root))?.text === signature;
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

/** Whether somebody writes the project at this moment, as far as can be told. */
export async function isLocked(root: string, files: FileLayer): Promise<boolean> {
  const held = await readLock(root);
  return held !== null && !(await isLeft(root, held, files));
}

/** Removes the lock of any holder, at a person's request. The holder notices before it writes. */
export async function breakLock(root: string, files: FileLayer): Promise<void> {
  await files.remove(lockOf(root));
}

async function acquire(root: string, files: FileLayer, signature: string, patienceMs: number): Promise<void> {
  const startMs = Date.now();
  while (!(await tryToTake(root, files, signature))) {
    if (await breakIfLeft(root, files)) continue;
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

/** By a link, so that the lock is never seen without its owner; FAT has no links. */
async function tryToTake(root: string, files: FileLayer, signature: string): Promise<boolean> {
  const bytes = new TextEncoder().encode(signature);
  const temporary = temporaryIn(root);
  try {
    await files.writeNew(temporary, bytes);
    await files.link(temporary, lockOf(root)).catch(async (error: unknown) => {
      if (errorCode(error) === 'EEXIST') throw error;
      await files.writeNew(lockOf(root), bytes);
    });
    return true;
  } catch (error) {
    if (errorCode(error) === 'EEXIST') return false;
    throw error;
  } finally {
    await files.remove(temporary).catch(() => {});
  }
}

/** Writes the signature again, so that the disk's own clock dates the lock, as it dates the probe of `isLeft`. Leaves others' locks alone. */
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

/** Removes an abandoned lock. Returns true if there may be none now. */
async function breakIfLeft(root: string, files: FileLayer): Promise<boolean> {
  const held = await readLock(root);
  if (held === null) return true;
  if (!(await isLeft(root, held, files))) return false;
  const aside = temporaryIn(root);
  try {
    await files.rename(lockOf(root), aside);
  } catch (error) {
    if (errorCode(error) === 'ENOENT') return true;
    throw error;
  }
  // Somebody else may have broken it, and locked, between the look and the rename: then it is theirs, and goes back.
  if ((await readLock(root, aside))?.text !== held.text) await files.link(aside, lockOf(root)).catch(() => {});
  await files.remove(aside);
  return true;
}

interface SeenLock {
  /** Null for what is no lock of ours: a pipe, a link, a folder, a text of any length. */
  readonly text: string | null;
  readonly touchedMs: number;
}

/**
 * What is no lock was put there by no save. Else: the process is known to have ended, or its last touch is long ago by the clock
 * of the disk, which a file tells that is written now; a date that lies ahead is as good as none. Where no file can be written,
 * nobody's save is under way that this one could meet.
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

/** Null where there is none. */
async function readLock(root: string, path = lockOf(root)): Promise<SeenLock | null> {
  const found = await lstat(path).catch(() => null);
  if (found === null) return null;
  const text = await readText(path, MAX_SIGNATURE_BYTES).catch((error: unknown) => {
    if (errorCode(error) === 'ENOENT') return undefined;
    return null;
  });
  return text === undefined ? null : { text, touchedMs: found.mtimeMs };
}

function lockOf(root: string): string {
  return join(root, SCRIM_FOLDER, LOCK_NAME);
}
