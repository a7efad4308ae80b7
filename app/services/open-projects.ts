import { randomBytes } from 'node:crypto';
import { mkdir, readdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import type { HostEvent, OpenProject, ProjectFiles } from '../contract/contract.ts';
import { realFolder } from './confine.ts';
import type { Content } from './content.ts';
import { copyAssets } from './copy-assets.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { changesBetween, findProject, listAssets, readProjectFiles, revisionOf } from './project-files.ts';
import { findUnsaved, keepUnsaved } from './recovery.ts';
import { finishInterrupted, writeAll } from './transaction.ts';
import { watchProject } from './watch-project.ts';

/** The projects that the editor has open, by handle. */
export interface OpenProjects {
  open(path: string): Promise<OpenProject>;
  save(handle: string, files: ProjectFiles, revision: string, overwrite: boolean): Promise<{ revision: string }>;
  saveAs(handle: string, path: string, files: ProjectFiles): Promise<OpenProject>;
  autosave(handle: string, files: ProjectFiles | null): Promise<void>;
  close(handle: string): void;
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
}

/** A page that is reloaded never closes what it had open; nobody works on this many at once. */
const MAX_OPEN = 32;

interface Entry {
  readonly root: string;
  readonly baseUrl: string;
  /** Revision of what the editor knows to be on the disk. */
  known: string;
  readonly close: () => void;
}

export function createOpenProjects({ content, previewOrigin, files, emit }: OpenProjectsOptions): OpenProjects {
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

  const openAt = async (root: string, displayPath: string): Promise<OpenProject> => {
    await finishInterrupted(root, files).catch((error: unknown) => {
      throw writeRefusal(error, root);
    });
    const projectFiles = await readProjectFiles(root);
    const handle = randomBytes(16).toString('hex');
    const mount = `projects/${randomBytes(16).toString('hex')}`;
    const hide = content.show(mount, root);
    const watcher = watchProject(root, (revision) => void noticed(handle, revision));
    const revision = revisionOf(projectFiles);
    const baseUrl = `${previewOrigin}/${mount}/`;
    const [oldest] = entries.keys();
    if (oldest !== undefined && entries.size >= MAX_OPEN) close(oldest);
    const release = () => {
      watcher.dispose();
      hide();
    };
    entries.set(handle, { root, baseUrl, known: revision, close: release });
    const recovery = await findUnsaved(root, projectFiles);
    return { handle, displayPath, files: projectFiles, revision, assetBaseUrl: baseUrl, assetFiles: await listAssets(root), recovery };
  };

  /** Tells of a change once per revision; a save that is under way ends first, so that it is not taken for someone else's. */
  const noticed = async (handle: string, revision: string) => {
    const entry = entries.get(handle);
    if (!entry) return;
    await writing.get(entry.root);
    if (entry.known === revision || !entries.has(handle)) return;
    const now = revisionOf(await readProjectFiles(entry.root).catch(() => ({ project: '', layout: null, sources: {} })));
    if (now !== revision) return;
    entry.known = revision;
    emit({ kind: 'project-changed-outside', handle, revision });
  };

  return {
    open: async (path) => openAt(await findProject(path), path),
    save: (handle, next, revision, overwrite) => {
      const entry = entryOf(handle);
      return inTurn(entry, async () => {
        const current = await readProjectFiles(entry.root).catch(() => null);
        if (!overwrite && (current === null || revisionOf(current) !== revision)) {
          throw refusal(
            'SCR063',
            'The project was changed on the disk since it was opened here. Nothing was saved.',
            'Reload it to take that version, or save over it.',
          );
        }
        await write(entry.root, changesBetween(current, next), files);
        entry.known = revisionOf(next);
        await keepUnsaved(entry.root, null, files);
        return { revision: entry.known };
      });
    },
    saveAs: async (handle, path, next) => {
      const from = entryOf(handle).root;
      const root = await emptyFolder(path);
      try {
        await copyAssets(from, root, files);
        await write(root, changesBetween(null, next), files);
      } catch (error) {
        // The folder was empty: whatever is in it is ours.
        for (const name of await readdir(root)) await files.remove(join(root, name));
        throw writeRefusal(error, path);
      }
      return openAt(root, path);
    },
    autosave: (handle, work) => {
      const entry = entryOf(handle);
      return inTurn(entry, () =>
        keepUnsaved(entry.root, work, files).catch((error: unknown) => {
          throw writeRefusal(error, entry.root);
        }),
      );
    },
    close,
    rootOf: (handle) => entryOf(handle).root,
    baseUrlOf: (handle) => entryOf(handle).baseUrl,
    dispose: () => {
      for (const entry of entries.values()) entry.close();
      entries.clear();
    },
  };
}

async function write(root: string, changes: Map<string, Uint8Array | null>, files: FileLayer): Promise<void> {
  try {
    await writeAll(root, changes, files);
  } catch (error) {
    throw writeRefusal(error, root);
  }
}

/** The folder, made where it is missing. Throws SCR061 where it holds something. */
async function emptyFolder(path: string): Promise<string> {
  const absolute = resolve(path);
  try {
    await mkdir(absolute, { recursive: true });
    const names = await readdir(absolute);
    if (names.length > 0) throw refusal('SCR061', `${path} is not empty. Nothing was saved.`, 'Choose a new or an empty folder.');
  } catch (error) {
    throw writeRefusal(error, path);
  }
  return realFolder(absolute);
}
