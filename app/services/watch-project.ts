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

/** An editor that saves touches several files; they are read once all is quiet for this long. */
const QUIET_MS = 150;

/** A shader is seen as soon as it is saved; an editor writes one file in a few steps that come right after each other. */
const SHADER_QUIET_MS = 20;

/** Programs empty a file before they write it anew: one that is found empty is looked at so often again until it is taken for that. */
const LOOKS_AT_EMPTY = 20;

export interface ProjectWatch {
  dispose(): void;
}

/**
 * Calls `onRevision` with the folder's revision after something in it changed. It says nothing of who changed it: the caller
 * compares with the revision it wrote itself. A folder in the middle of a change (a file gone for a moment, or empty) is left
 * for the next event.
 */
export function watchProject(root: string, files: FileLayer, onRevision: (revision: string) => void): ProjectWatch {
  let timer: NodeJS.Timeout | undefined;
  let disposed = false;
  /** Files that were empty when the folder was last told of. */
  let empty: readonly string[] = [];
  let looks = 0;
  /** Not every system watches what is below a folder: each has a watcher of its own. */
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
    // Another process is in the middle of a save: half of it would be taken for a change of its own.
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

/** Null where the folder is missing or the system has no watchers left: the project opens all the same. */
function watchFolder(path: string, onChange: () => void): FSWatcher | null {
  try {
    const watcher = watch(path, { persistent: false }, onChange);
    watcher.on('error', () => watcher.close());
    return watcher;
  } catch {
    return null;
  }
}
