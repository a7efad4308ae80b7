import { randomBytes } from 'node:crypto';
import { lstat } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { MAX_ASSET_BYTES } from '../contract/call-parts.ts';
import { resolveInside } from './confine.ts';
import { errorCode } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { readBytes, readText } from './read-file.ts';
import { ensureScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

/** New bytes by project path; null deletes the file. */
export type Changes = ReadonlyMap<string, Uint8Array | null>;

/** Journal of a save, forward or backward. Each step is idempotent. */
interface Journal {
  readonly direction: 'forward' | 'back';
  readonly staging: string;
  readonly changes: readonly Change[];
}

interface Change {
  readonly path: string;
  readonly action: 'write' | 'remove';
  /** Whether the file existed before. */
  readonly had: boolean;
}

export const JOURNAL_NAME = 'save.json';
const JOURNAL = `${SCRIM_FOLDER}/${JOURNAL_NAME}`;

/** Limit of the journal, which names some hundred files. */
const MAX_JOURNAL_BYTES = 16 * 2 ** 20;

/**
 * Writes several files of a project atomically: all or none, even if an operation fails or the process dies. The caller holds the
 * lock of the project or has just created its folder. `stillMine` rejects if the lock has been broken; nothing is written then.
 *
 * 1. New files are written to a staging folder in `.scrim` and flushed to the disk. Old files are linked there.
 * 2. The journal is renamed into place. From then on the save will be completed, if necessary by `finishInterrupted` when the project
 * is next opened.
 * 3. Each new file is renamed over the old one. After an error the journal is reversed and the old files are restored.
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
      await rollBack(root, journal, files);
      await cleanUp(root, staging, files);
    }
    // An existing journal belongs to another process.
    else await files.remove(join(root, staging));
    throw error;
  }
  // All files are written. Failures to clean up are not failures of the save.
  await cleanUp(root, staging, files).catch(() => {});
}

/** Restores the old files. If that fails, the journal stays and the next opening continues. */
async function rollBack(root: string, journal: Journal, files: FileLayer): Promise<void> {
  const back: Journal = { ...journal, direction: 'back' };
  await placeJournal(root, await draftJournal(root, back, files), files);
  await finish(root, back, files);
}

/** Completes a save whose process died. The caller holds the lock of the project. */
export async function finishInterrupted(root: string, files: FileLayer): Promise<void> {
  const text = await readText(await resolveInside(root, JOURNAL), MAX_JOURNAL_BYTES).catch((error: unknown) =>
    // Anything but a file is not from a save. It is removed like an empty journal.
    errorCode(error) === 'ENOENT' ? null : '',
  );
  if (text === null) return;
  const journal = parseJournal(text);
  if (journal) {
    await resolveInside(root, journal.staging);
    for (const { path } of journal.changes) await resolveInside(root, path);
    await finish(root, journal, files);
  }
  await cleanUp(root, journal?.staging ?? null, files);
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

/** Keeps the old file by a hard link, or by a copy on file systems without links (FAT). */
export async function keepOld(target: string, kept: string, files: FileLayer): Promise<void> {
  try {
    await files.link(target, kept);
  } catch {
    await files.writeNew(kept, await readBytes(target, MAX_ASSET_BYTES));
  }
}

let journalCount = 0;

/** Writes the journal to a temporary file. Returns its path. */
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

/** Deletes the journal first: without it, the staging folder has no effect. */
async function cleanUp(root: string, staging: string | null, files: FileLayer): Promise<void> {
  await files.remove(join(root, JOURNAL));
  if (staging !== null) await files.remove(join(root, staging));
}

/** File name in the staging folder. `!` replaces path separators; it is valid on all systems. */
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
