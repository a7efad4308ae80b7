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
  /** Shaders that the window has loaded. A save deletes no others. */
  readonly loaded: ReadonlySet<string>;
  /** The expected revision of the folder. Null overwrites any version and keeps a copy of it. */
  readonly revision: string | null;
  readonly files: FileLayer;
}

export interface SaveOutcome {
  /** The files of the folder after the save, including those that others added. */
  readonly saved: ProjectFiles;
  /** Project path of the folder with the replaced files; null if nothing was replaced. */
  readonly kept: string | null;
}

/**
 * Saves the texts of a project. Holds the lock, so that no other process can write between check and write.
 *
 * @throws SCR004, SCR060, SCR062, SCR063, SCR066, SCR067
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

/** Reads the current files. Null if there is no project, or if it cannot be read and will be overwritten. */
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

/** Links files that will be replaced or deleted into a folder of their own. Null if there are none. */
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
