import { randomBytes } from 'node:crypto';
import type { HostEvent, OpenProject, ProjectFiles } from '../contract/contract.ts';
import type { Content } from './content.ts';
import { copyAssets } from './copy-assets.ts';
import { fillEmptyFolder } from './empty-folder.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { outsideChange } from './outside-change.ts';
import { isShownByOthers, leaveSign, takeSignAway } from './presence.ts';
import { changesBetween, findProject, listAssets, readProjectFiles, revisionOf } from './project-files.ts';
import { withLock } from './project-lock.ts';
import { keepUnsaved, takeOverUnsaved } from './recovery.ts';
import { readSettled } from './settle.ts';
import { finishInterrupted, writeAll } from './transaction.ts';
import { watchProject } from './watch-project.ts';

/** The projects that the editor has open, by handle. `client` is the window or tab that asks. */
export interface OpenProjects {
  open(path: string, client: string): Promise<OpenProject>;
  save(handle: string, files: ProjectFiles, revision: string, overwrite: boolean): Promise<{ revision: string }>;
  saveAs(handle: string, path: string, files: ProjectFiles, client: string): Promise<OpenProject>;
  autosave(handle: string, files: ProjectFiles | null): Promise<void>;
  close(handle: string): void;
  /** The window or tab is gone, and has closed nothing. */
  left(client: string): void;
  /** The real folder of an open project. Throws SCR073. */
  rootOf(handle: string): string;
  /** Where the preview reads the project's files; ends in `/`. */
  baseUrlOf(handle: string): string;
  dispose(): void;
}

export interface OpenProjectsOptions {
  readonly content: Content;
  readonly previewOrigin: string;
  readonly files: FileLayer;
  readonly emit: (event: HostEvent) => void;
  /** Whether the window or tab is still there: a page that was reloaded, or died, never closes what it had open. */
  readonly isThere: (client: string) => boolean;
}

/** Nobody works on this many at once: the oldest are what reloaded pages left open. */
const MAX_OPEN = 32;

interface Entry {
  readonly root: string;
  readonly baseUrl: string;
  readonly client: string;
  /** What the editor knows to be on the disk, and its revision. */
  files: ProjectFiles;
  known: string;
  readonly close: () => void;
}

export function createOpenProjects({ content, previewOrigin, files, emit, isThere }: OpenProjectsOptions): OpenProjects {
  const entries = new Map<string, Entry>();
  /** Folder → what is being written there at this moment; changes seen meanwhile are our own. */
  const writing = new Map<string, Promise<unknown>>();

  const entryOf = (handle: string): Entry => {
    const entry = entries.get(handle);
    if (!entry) throw refusal('SCR073', 'The project is not open any more.', 'Open it again.');
    return entry;
  };

  /** One at a time and in order: writes to one folder never overlap, though two tabs may have it open. */
  const inTurn = <T>({ root }: Entry, task: () => Promise<T>): Promise<T> => {
    const result = Promise.resolve(writing.get(root)).then(task);
    const done = result
      .catch(() => {})
      .then(() => {
        if (writing.get(root) === done) writing.delete(root);
      });
    writing.set(root, done);
    return result;
  };

  const close = (handle: string): void => {
    entryOf(handle).close();
    entries.delete(handle);
  };

  const openAt = async (root: string, displayPath: string, client: string): Promise<OpenProject> => {
    const handle = randomBytes(16).toString('hex');
    // Watched before it is read: what changes in between is noticed.
    const watcher = watchProject(root, (revision) => void noticed(handle, revision));
    const projectFiles = await readSettled(root, files).catch((error: unknown) => {
      watcher.dispose();
      throw error;
    });
    const mount = `projects/${randomBytes(16).toString('hex')}`;
    const hide = content.show(mount, root);
    const revision = revisionOf(projectFiles);
    const baseUrl = `${previewOrigin}/${mount}/`;
    makeRoom();
    const release = () => {
      watcher.dispose();
      hide();
      takeSignAway(root, handle);
    };
    entries.set(handle, { root, baseUrl, client, files: projectFiles, known: revision, close: release });
    try {
      await leaveSign(root, handle, files);
      const recovery = await takeOverUnsaved(root, handle, projectFiles, isMinded, files);
      const assetFiles = await listAssets(root);
      const openElsewhere = isShownBeside(root, client) || (await isShownByOthers(root));
      return { handle, displayPath, files: projectFiles, revision, assetBaseUrl: baseUrl, assetFiles, recovery, openElsewhere };
    } catch (error) {
      // Nobody hears of the handle, so nobody would close it.
      close(handle);
      throw error;
    }
  };

  const makeRoom = () => {
    if (entries.size < MAX_OPEN) return;
    const abandoned = [...entries].find(([, { client }]) => !isThere(client))?.[0];
    const [oldest] = entries.keys();
    const closed = abandoned ?? oldest;
    if (closed !== undefined) close(closed);
  };

  const isMinded = (handle: string): boolean => {
    const entry = entries.get(handle);
    return entry !== undefined && isThere(entry.client);
  };

  const isShownBeside = (root: string, client: string): boolean =>
    [...entries.values()].some((entry) => entry.root === root && entry.client !== client && isThere(entry.client));

  /** Tells of a change once per revision; a save that is under way ends first, so that it is not taken for someone else's. */
  const noticed = async (handle: string, revision: string) => {
    const entry = entries.get(handle);
    if (!entry) return;
    await writing.get(entry.root);
    if (entry.known === revision || !entries.has(handle)) return;
    const now = await readProjectFiles(entry.root).catch(() => null);
    if (now === null || revisionOf(now) !== revision || entry.known === revision) return;
    const event = outsideChange(handle, entry.files, now);
    entry.known = revision;
    entry.files = now;
    emit(event);
  };

  return {
    open: async (path, client) => openAt(await findProject(path), path, client),
    save: (handle, next, revision, overwrite) => {
      const entry = entryOf(handle);
      return inTurn(entry, async () => {
        await saveOver(entry.root, next, overwrite ? null : revision, files);
        entry.known = revisionOf(next);
        entry.files = next;
        // It is saved: what could not be forgotten is found to be no news at the next opening.
        await keepUnsaved(entry.root, handle, null, files).catch(() => {});
        return { revision: entry.known };
      });
    },
    saveAs: async (handle, path, next, client) => {
      const from = entryOf(handle).root;
      const root = await fillEmptyFolder(path, files, async (folder) => {
        await copyAssets(from, folder, files);
        await writeAll(folder, changesBetween(null, next), files);
      });
      return openAt(root, path, client);
    },
    autosave: (handle, work) => {
      const entry = entryOf(handle);
      return inTurn(entry, () =>
        keepUnsaved(entry.root, handle, work, files).catch((error: unknown) => {
          throw writeRefusal(error, entry.root);
        }),
      );
    },
    close,
    left: (client) => {
      for (const [handle, entry] of entries) if (entry.client === client) takeSignAway(entry.root, handle);
    },
    rootOf: (handle) => entryOf(handle).root,
    baseUrlOf: (handle) => entryOf(handle).baseUrl,
    dispose: () => {
      for (const entry of entries.values()) entry.close();
      entries.clear();
    },
  };
}

/**
 * Writes `next` where the folder still holds `revision`; null writes it over whatever is there. The look and the write are one
 * step for every other window and process. Throws SCR060, SCR062 and SCR063.
 */
async function saveOver(root: string, next: ProjectFiles, revision: string | null, files: FileLayer): Promise<void> {
  try {
    await withLock(root, files, async () => {
      await finishInterrupted(root, files);
      const current = await readProjectFiles(root).catch(() => null);
      if (revision !== null && (current === null || revisionOf(current) !== revision)) {
        throw refusal(
          'SCR063',
          'The project was changed on the disk since it was opened here. Nothing was saved.',
          'Reload it to take that version, or save over it.',
        );
      }
      await writeAll(root, changesBetween(current, next), files);
    });
  } catch (error) {
    throw writeRefusal(error, root);
  }
}
