import { randomBytes } from 'node:crypto';
import { lstat } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { MAX_ASSET_BYTES } from '../contract/contract.ts';
import { resolveInside } from './confine.ts';
import { errorCode } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { readBytes, readText } from './read-file.ts';
import { ensureScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

/** Project path → its new bytes, or null to remove it. */
export type Changes = ReadonlyMap<string, Uint8Array | null>;

/** What a save was about to do, or to take back. Every step of it may be done twice. */
interface Journal {
  readonly direction: 'forward' | 'back';
  readonly staging: string;
  readonly changes: readonly Change[];
}

interface Change {
  readonly path: string;
  readonly action: 'write' | 'remove';
  /** Whether there was a file before. */
  readonly had: boolean;
}

export const JOURNAL_NAME = 'save.json';
const JOURNAL = `${SCRIM_FOLDER}/${JOURNAL_NAME}`;

/** It names some hundred files. */
const MAX_JOURNAL_BYTES = 16 * 2 ** 20;

/**
 * Writes several files of a project as one: all of them or none, whether an operation fails or the process dies. The caller
 * holds the project's lock, or has just made its folder. `stillMine` rejects where that lock has been broken: nothing is written then.
 *
 * 1. New bytes go to a staging folder inside `.scrim` and onto the disk; the old files get a second name there.
 * 2. The journal is renamed into place. Before that moment nothing has happened; after it the save will be finished, by
 *    `finishInterrupted` at the next opening if need be.
 * 3. Each new file is renamed over the old one. An error here turns the journal round, and puts the old ones back.
 */
export async function writeAll(root: string, changes: Changes, files: FileLayer, stillMine = async () => {}): Promise<void> {
  if (changes.size === 0) return;
  for (const path of changes.keys()) await resolveInside(root, path);
  await ensureScrimFolder(root, files);
  const staging = `${SCRIM_FOLDER}/save-${randomBytes(6).toString('hex')}`;
  let journal: Journal | null = null;
  try {
    const forward: Journal = { direction: 'forward', staging, changes: await stage(root, staging, changes, files) };
    const draft = await draftJournal(root, forward, files);
    await stillMine();
    journal = forward;
    await placeJournal(root, draft, files);
    await finish(root, journal, files);
  } catch (error) {
    if (journal) {
      await takeBack(root, journal, files);
      await forget(root, staging, files);
    }
    // A journal that is there now is somebody else's.
    else await files.remove(join(root, staging));
    throw error;
  }
  // All is written: what cannot be tidied away now is no failed save.
  await forget(root, staging, files).catch(() => {});
}

/** Where even this fails, the journal stays and the next opening goes on. */
async function takeBack(root: string, journal: Journal, files: FileLayer): Promise<void> {
  const back: Journal = { ...journal, direction: 'back' };
  await placeJournal(root, await draftJournal(root, back, files), files);
  await finish(root, back, files);
}

/** Ends a save that the process did not live to end. The caller holds the project's lock. */
export async function finishInterrupted(root: string, files: FileLayer): Promise<void> {
  const text = await readText(await resolveInside(root, JOURNAL), MAX_JOURNAL_BYTES).catch((error: unknown) =>
    // What is no file was put there by no save: it is taken away like a journal that says nothing.
    errorCode(error) === 'ENOENT' ? null : '',
  );
  if (text === null) return;
  const journal = parseJournal(text);
  if (journal) {
    await resolveInside(root, journal.staging);
    for (const { path } of journal.changes) await resolveInside(root, path);
    await finish(root, journal, files);
  }
  await forget(root, journal?.staging ?? null, files);
}

async function stage(root: string, staging: string, changes: Changes, files: FileLayer): Promise<Change[]> {
  await files.makeFolder(join(root, staging));
  const staged: Change[] = [];
  for (const [path, bytes] of changes) {
    const target = join(root, path);
    if (bytes) {
      await files.makeFolder(dirname(target));
      await files.writeNew(join(root, newName(staging, path)), bytes);
    }
    const had = await exists(target);
    if (had) await keepOld(target, join(root, oldName(staging, path)), files);
    staged.push({ path, action: bytes ? 'write' : 'remove', had });
  }
  await files.syncFolder(join(root, staging));
  return staged;
}

/** A second name where the file system has links (FAT has none), else a copy. */
export async function keepOld(target: string, kept: string, files: FileLayer): Promise<void> {
  try {
    await files.link(target, kept);
  } catch {
    await files.writeNew(kept, await readBytes(target, MAX_ASSET_BYTES));
  }
}

let journalCount = 0;

/** Answers with where it lies until it is in force. */
async function draftJournal(root: string, journal: Journal, files: FileLayer): Promise<string> {
  const draft = join(root, journal.staging, `journal-${journalCount++}`);
  await files.writeNew(draft, new TextEncoder().encode(JSON.stringify(journal)));
  return draft;
}

async function placeJournal(root: string, draft: string, files: FileLayer): Promise<void> {
  await files.rename(draft, join(root, JOURNAL));
  await files.syncFolder(join(root, SCRIM_FOLDER));
}

async function finish(root: string, { direction, staging, changes }: Journal, files: FileLayer): Promise<void> {
  for (const change of changes) {
    const target = join(root, change.path);
    const wanted = direction === 'forward' ? change.action === 'write' : change.had;
    const source = join(root, direction === 'forward' ? newName(staging, change.path) : oldName(staging, change.path));
    if (!wanted) await files.remove(target);
    else if (await exists(source)) await files.rename(source, target);
  }
  for (const folder of new Set(changes.map(({ path }) => dirname(join(root, path))))) await files.syncFolder(folder);
}

/** The journal first: without it, what is left of the staging folder means nothing. */
async function forget(root: string, staging: string | null, files: FileLayer): Promise<void> {
  await files.remove(join(root, JOURNAL));
  if (staging !== null) await files.remove(join(root, staging));
}

/** Flat, so that staging is one folder; `!` separates nothing on any system. */
function newName(staging: string, path: string): string {
  return `${staging}/new-${path.replaceAll('/', '!')}`;
}

function oldName(staging: string, path: string): string {
  return `${staging}/old-${path.replaceAll('/', '!')}`;
}

function parseJournal(text: string): Journal | null {
  try {
    const journal = JSON.parse(text) as Journal;
    const plain = /^\.scrim\/save-[0-9a-f]{12}$/.test(journal.staging) && ['forward', 'back'].includes(journal.direction);
    return plain && journal.changes.every(({ path }) => typeof path === 'string') ? journal : null;
  } catch {
    return null;
  }
}

async function exists(path: string): Promise<boolean> {
  return lstat(path).then(
    () => true,
    () => false,
  );
}
