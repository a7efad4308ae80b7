import { lstat } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { ProjectFiles } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { changesBetween, PROJECT_FILE, readProjectFiles, revisionOf } from './project-files.ts';
import { withLock } from './project-lock.ts';
import { removeOldReplaced, replacedFolder } from './replaced-folders.ts';
import { requireFolder } from './scrim-folder.ts';
import { type Changes, finishInterrupted, keepOld, writeAll } from './transaction.ts';

export interface SaveJob {
  readonly root: string;
  readonly next: ProjectFiles;
  /** Shaders that the window has loaded. A save removes no other ones. */
  readonly loaded: ReadonlySet<string>;
  /** What the folder has to hold; null writes over whatever is there, and keeps that. */
  readonly revision: string | null;
  readonly files: FileLayer;
}

export interface SaveOutcome {
  /** What the folder holds now: what was saved, and what others have added. */
  readonly saved: ProjectFiles;
  /** Project path of the folder with what was written over; null where nothing was. */
  readonly kept: string | null;
}

/**
 * Writes a project's texts. The look and the write are one step for every other window and process. Throws SCR004, SCR060, SCR062,
 * SCR063, SCR066 and SCR067.
 */
export async function saveOver({ root, next, loaded, revision, files }: SaveJob): Promise<SaveOutcome> {
  try {
    await requireFolder(root);
    return await withLock(root, files, async ({ stillMine }) => {
      await finishInterrupted(root, files);
      const current = await readCurrent(root, revision !== null);
      if (revision !== null && (current === null || revisionOf(current) !== revision)) throw changedOutside();
      const added = Object.entries(current?.sources ?? {}).filter(([name]) => !loaded.has(name) && !Object.hasOwn(next.sources, name));
      const saved: ProjectFiles = { ...next, sources: { ...Object.fromEntries(added), ...next.sources } };
      const changes = changesBetween(current, saved);
      const now = new Date();
      const kept = revision === null ? await keepReplaced(root, replacedFolder(now), changes, files) : null;
      try {
        await writeAll(root, changes, files, stillMine);
      } catch (error) {
        if (kept !== null) await files.remove(join(root, kept)).catch(() => {});
        throw error;
      }
      // The save is complete; a folder that cannot be removed is tried again after the next one.
      if (kept !== null) await removeOldReplaced(root, now, files).catch(() => {});
      return { saved, kept };
    });
  } catch (error) {
    throw writeRefusal(error, root);
  }
}

/** Null where there is no project file, or where what is there is to be written over and cannot be read. */
async function readCurrent(root: string, mustRead: boolean): Promise<ProjectFiles | null> {
  try {
    return await readProjectFiles(root);
  } catch (error) {
    const isThere = await lstat(join(root, PROJECT_FILE)).then(
      () => true,
      () => false,
    );
    if (mustRead && isThere && error instanceof HostError) throw error;
    return null;
  }
}

function changedOutside(): HostError {
  return refusal(
    'SCR063',
    'The project changed on the disk since you opened it. Nothing was saved.',
    'Reload it to get that version, or save over it.',
  );
}

/** Gives what is about to be replaced or removed a second name in a folder of its own; null where nothing is. */
async function keepReplaced(root: string, folder: string, changes: Changes, files: FileLayer): Promise<string | null> {
  let count = 0;
  for (const path of changes.keys()) {
    const target = join(root, path);
    if ((await lstat(target).catch(() => null)) === null) continue;
    await files.makeFolder(dirname(join(root, folder, path)));
    await keepOld(target, join(root, folder, path), files);
    count++;
  }
  return count === 0 ? null : folder;
}
