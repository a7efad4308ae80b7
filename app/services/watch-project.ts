import { type FSWatcher, watch } from 'node:fs';
import { join } from 'node:path';
import type { ProjectFiles } from '../contract/contract.ts';
import type { FileLayer } from './file-layer.ts';
import {
  CHUNKS_FOLDER,
  LAYOUT_FILE,
  listChunkFolders,
  PROJECT_FILE,
  readProjectFiles,
  revisionOf,
  SHADERS_FOLDER,
} from './project-files.ts';
import { isLocked } from './project-lock.ts';

/** Saves touch several files. They are read after a pause of this length. */
const QUIET_MS = 150;

/** Pause after changes of shaders. Shorter, because an editor writes a single file in quick steps. */
const SHADER_QUIET_MS = 20;

/** Many programs truncate a file before they write it. An empty file is read this many times before it counts as empty. */
const LOOKS_AT_EMPTY = 20;

export interface ProjectWatch {
  dispose(): void;
}

/**
 * Calls `onRevision` with the revision of the folder after each change, including our own saves; the caller compares revisions.
 * Incomplete states (a file missing for a moment, or empty) are skipped until the next event.
 */
export function watchProject(root: string, files: FileLayer, onRevision: (revision: string) => void): ProjectWatch {
  let timer: NodeJS.Timeout | undefined;
  let disposed = false;
  /** Files that were empty at the last report. */
  let empty: readonly string[] = [];
  let looks = 0;
  /** One watcher per folder, because not all systems watch subfolders. */
  const watchers = new Map<string, FSWatcher>();

  const follow = (path: string, onChange: () => void) => {
    const watcher = watchers.has(path) || disposed ? null : watchFolder(join(root, path), onChange);
    if (!watcher) return;
    watchers.set(path, watcher);
    watcher.on('close', () => watchers.delete(path));
  };
  const followShaders = async () => {
    follow(SHADERS_FOLDER, touchShader);
    const folders = await listChunkFolders(root).catch((): string[] => []);
    for (const folder of folders) follow(folder, touchShader);
    // A watcher does not follow a folder that is deleted and created again, so watchers of missing folders are closed.
    for (const [path, watcher] of watchers) if (path.startsWith(CHUNKS_FOLDER) && !folders.includes(path)) watcher.close();
  };

  const read = async () => {
    // Another process is saving; an incomplete save must not be reported.
    if (await isLocked(root, files)) {
      if (!disposed) touch();
      return;
    }
    await followShaders();
    const texts = await readProjectFiles(root).catch(() => null);
    if (!texts || disposed) return;
    const emptyNow = emptyFiles(texts);
    if (emptyNow.some((path) => !empty.includes(path)) && looks++ < LOOKS_AT_EMPTY) {
      touch();
      return;
    }
    looks = 0;
    empty = emptyNow;
    onRevision(revisionOf(texts));
  };
  const readAfter = (ms: number) => {
    clearTimeout(timer);
    timer = setTimeout(() => void read(), ms);
  };
  const touch = () => readAfter(QUIET_MS);
  const touchShader = () => readAfter(SHADER_QUIET_MS);

  follow('', touch);
  void followShaders();
  return {
    dispose: () => {
      disposed = true;
      clearTimeout(timer);
      for (const watcher of watchers.values()) watcher.close();
    },
  };
}

function emptyFiles({ project, layout, sources }: ProjectFiles): string[] {
  const texts = Object.entries({ ...sources, [PROJECT_FILE]: project, [LAYOUT_FILE]: layout });
  return texts.filter(([, text]) => text === '').map(([path]) => path);
}

/** Watches a folder; null if the folder is missing or the system has no watchers left. The project opens anyway. */
function watchFolder(path: string, onChange: () => void): FSWatcher | null {
  try {
    const watcher = watch(path, { persistent: false }, onChange);
    watcher.on('error', () => watcher.close());
    return watcher;
  } catch {
    return null;
  }
}
