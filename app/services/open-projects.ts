import { randomBytes } from 'node:crypto';
import type { HostEvent, OpenProject, ProjectFiles } from '../contract/contract.ts';
import type { Content } from './content.ts';
import { copyAssets } from './copy-example.ts';
import { fillEmptyFolder } from './empty-folder.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { isShownByOthers, leaveSign, removeSign } from './presence.ts';
import { changesBetween, findProject, listAssets, readProjectFiles, revisionOf } from './project-files.ts';
import { breakLock } from './project-lock.ts';
import { readConsistentFiles } from './recover-folder.ts';
import { keepUnsaved, takeOverUnsaved } from './recovery.ts';
import { saveOver } from './save-over.ts';
import { writeAll } from './transaction.ts';
import { watchProject } from './watch-project.ts';

/** Open projects by project id. `client` is the window or tab that calls. */
export interface OpenProjects {
  open(path: string, client: string): Promise<OpenProject>;
  save(projectId: string, files: ProjectFiles, revision: string, overwrite: boolean): Promise<{ revision: string; kept: string | null }>;
  /** Removes the lock of another process. */
  breakLock(projectId: string): Promise<void>;
  saveAs(projectId: string, path: string, files: ProjectFiles, client: string): Promise<OpenProject>;
  autosave(projectId: string, files: ProjectFiles | null): Promise<void>;
  close(projectId: string): void;
  /** Closes the projects of a closed window or tab. */
  left(client: string): void;
  /**
   * Real path of an open project.
   *
   * @throws SCR073
   */
  rootOf(projectId: string): string;
  /** URL of the project’s files for the preview, ending in `/`. */
  baseUrlOf(projectId: string): string;
  dispose(): void;
}

export interface OpenProjectsOptions {
  readonly content: Content;
  readonly previewOrigin: string;
  readonly files: FileLayer;
  readonly emit: (event: HostEvent) => void;
  /** Whether a client still exists. Reloaded or crashed pages never close their projects. */
  readonly isThere: (client: string) => boolean;
}

/** Maximum number of open projects. The oldest ones belong to reloaded pages. */
const MAX_OPEN = 32;

interface Entry {
  readonly root: string;
  readonly baseUrl: string;
  readonly client: string;
  /** The files and revision that the window last read or wrote. */
  files: ProjectFiles;
  known: string;
  /** File names of shaders that the window has loaded or written, and therefore may delete. */
  readonly loaded: Set<string>;
  readonly close: () => void;
}

export function createOpenProjects({ content, previewOrigin, files, emit, isThere }: OpenProjectsOptions): OpenProjects {
  const entries = new Map<string, Entry>();
  /** Current writes by folder. Changes that are noticed meanwhile are our own. */
  const writing = new Map<string, Promise<unknown>>();

  const entryOf = (projectId: string): Entry => {
    const entry = entries.get(projectId);
    if (!entry) throw refusal('SCR073', 'The project is no longer open.', 'Open it again.');
    return entry;
  };

  /** Runs tasks on a folder one after another, because two tabs may have it open. */
  const enqueue = <T>({ root }: Entry, task: () => Promise<T>): Promise<T> => {
    const result = Promise.resolve(writing.get(root)).then(task);
    const done = result
      .catch(() => {})
      .then(() => {
        if (writing.get(root) === done) writing.delete(root);
      });
    writing.set(root, done);
    return result;
  };

  const close = (projectId: string): void => {
    entryOf(projectId).close();
    entries.delete(projectId);
  };

  const openAt = async (root: string, displayPath: string, client: string): Promise<OpenProject> => {
    const projectId = randomBytes(16).toString('hex');
    // Watches before reading, so that no change is missed in between.
    const watcher = watchProject(root, files, (revision) => void noticed(projectId, revision));
    const projectFiles = await readConsistentFiles(root, files).catch((error: unknown) => {
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
      removeSign(root, projectId);
    };
    const loaded = new Set(Object.keys(projectFiles.sources));
    entries.set(projectId, { root, baseUrl, client, files: projectFiles, known: revision, loaded, close: release });
    try {
      await leaveSign(root, projectId, files);
      const recovery = await takeOverUnsaved(root, projectId, projectFiles, isOwned, files);
      const assetFiles = await listAssets(root);
      const openElsewhere = isShownBeside(root, client) || (await isShownByOthers(root));
      return { handle: projectId, displayPath, files: projectFiles, revision, assetBaseUrl: baseUrl, assetFiles, recovery, openElsewhere };
    } catch (error) {
      // The editor never learns this id, so it could not close the project.
      close(projectId);
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

  const isOwned = (projectId: string): boolean => {
    const entry = entries.get(projectId);
    return entry !== undefined && isThere(entry.client);
  };

  const isShownBeside = (root: string, client: string): boolean =>
    [...entries.values()].some((entry) => entry.root === root && entry.client !== client && isThere(entry.client));

  /** Reports a change once per revision. Waits for a save in progress, so that it is not mistaken for an external change. */
  const noticed = async (projectId: string, revision: string) => {
    const entry = entries.get(projectId);
    if (!entry) return;
    await writing.get(entry.root);
    if (entry.known === revision || !entries.has(projectId)) return;
    const now = await readProjectFiles(entry.root).catch(() => null);
    if (now === null || revisionOf(now) !== revision || entry.known === revision) return;
    const event = outsideChange(projectId, entry.files, now);
    entry.known = revision;
    entry.files = now;
    // The window loads these shaders. Before other changes it asks, or reopens the project.
    if (event.kind === 'shaders-changed-outside') for (const { file } of event.shaders) entry.loaded.add(file);
    emit(event);
  };

  return {
    open: async (path, client) => openAt(await findProject(path), path, client),
    save: (projectId, next, revision, overwrite) => {
      const entry = entryOf(projectId);
      return enqueue(entry, async () => {
        const { saved, kept } = await saveOver({
          root: entry.root,
          next,
          loaded: entry.loaded,
          revision: overwrite ? null : revision,
          files,
        });
        entry.known = revisionOf(saved);
        entry.files = saved;
        for (const name of Object.keys(next.sources)) entry.loaded.add(name);
        // The project has been saved. Outdated recovery files are detected at the next start.
        await keepUnsaved(entry.root, projectId, null, files).catch(() => {});
        return { revision: entry.known, kept };
      });
    },
    breakLock: async (projectId) => {
      const { root } = entryOf(projectId);
      await breakLock(root, files).catch((error: unknown) => {
        throw writeRefusal(error, root);
      });
    },
    saveAs: async (projectId, path, next, client) => {
      const from = entryOf(projectId).root;
      const root = await fillEmptyFolder(path, files, async (folder) => {
        await copyAssets(from, folder, files);
        await writeAll(folder, changesBetween(null, next), files);
      });
      return openAt(root, path, client);
    },
    autosave: (projectId, work) => {
      const entry = entryOf(projectId);
      return enqueue(entry, () =>
        keepUnsaved(entry.root, projectId, work, files).catch((error: unknown) => {
          throw writeRefusal(error, entry.root);
        }),
      );
    },
    close,
    left: (client) => {
      for (const [projectId, entry] of entries) if (entry.client === client) removeSign(entry.root, projectId);
    },
    rootOf: (projectId) => entryOf(projectId).root,
    baseUrlOf: (projectId) => entryOf(projectId).baseUrl,
    dispose: () => {
      for (const entry of entries.values()) entry.close();
      entries.clear();
    },
  };
}

/**
 * The event for an external change of a folder: the shaders with their texts if nothing else changed, so that the editor applies them
 * at once; else only that the project changed.
 */
function outsideChange(projectId: string, before: ProjectFiles, now: ProjectFiles): HostEvent {
  const revision = revisionOf(now);
  if (before.project !== now.project || before.layout !== now.layout)
    return { kind: 'project-changed-outside', handle: projectId, revision };
  const names = new Set([...Object.keys(before.sources), ...Object.keys(now.sources)]);
  const shaders = [...names]
    .filter((file) => before.sources[file] !== now.sources[file])
    .sort()
    .map((file) => ({ file, before: before.sources[file] ?? null, text: now.sources[file] ?? null }));
  return { kind: 'shaders-changed-outside', handle: projectId, from: revisionOf(before), revision, shaders };
}
