import { randomBytes } from 'node:crypto';
import { dirname } from 'node:path';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { breakIfLeft, type LockPlace, readLock, type SeenLock, tryToTake } from './file-lock.ts';
import { isGone, OWNER, wordsOf } from './owner.ts';

/** Work that one process may do at a time. */
export interface LockedWork {
  /** Path of the lock file. Its folder exists. */
  readonly lock: string;
  readonly files: FileLayer;
  /** What is being done, for the message to the second process: `is importing the capture kitchen`. */
  readonly doing: string;
}

/** Signatures of the locks that this process holds. A lock in a folder that was moved meanwhile stays there. */
const held = new Set<string>();

/**
 * Runs a task of minutes while this process holds a lock file, which has the owner and a random number, because a process may lock repeatedly.
 * The lock of a process that has ended is taken over.
 *
 * @throws SCR060, SCR062, SCR066 if another process, or another window of this one, holds the lock
 */
export async function withWorkLock<T>({ lock, files, doing }: LockedWork, task: () => Promise<T>): Promise<T> {
  const signature = `${OWNER} ${randomBytes(8).toString('hex')}`;
  const place: LockPlace = { path: lock, temporary: () => `${lock}-${OWNER}-${randomBytes(6).toString('hex')}` };
  const take = () =>
    tryToTake(place, files, signature).catch((error: unknown) => {
      throw writeRefusal(error, dirname(lock));
    });
  held.add(signature);
  try {
    while (!(await take())) {
      const other = await breakIfLeft(place, files, isLeft);
      if (other === null) continue;
      throw refusal('SCR066', `${wordsOf(ownerOf(other.text ?? ''))} ${doing}.`, 'Wait until it has ended, or cancel it there.');
    }
    return await task();
  } finally {
    held.delete(signature);
    if ((await readLock(lock))?.text === signature) await files.remove(lock).catch(() => {});
  }
}

function isLeft({ text, touchedMs }: SeenLock): boolean {
  if (text === null) return true;
  const owner = ownerOf(text);
  return owner === OWNER ? !held.has(text) : isGone(owner, touchedMs);
}

function ownerOf(signature: string): string {
  return signature.split(' ')[0] ?? '';
}
