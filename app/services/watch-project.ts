import { type FSWatcher, watch } from 'node:fs';
import { join } from 'node:path';
import { readProjectFiles, revisionOf, SHADERS_FOLDER } from './project-files.ts';
import { isLocked } from './project-lock.ts';

/** An editor that saves touches several files; they are read once all is quiet for this long. */
const QUIET_MS = 150;

/** A shader is seen as soon as it is saved; an editor writes one file in a few steps that come right after each other. */
const SHADER_QUIET_MS = 20;

export interface ProjectWatch {
  dispose(): void;
}

/**
 * Calls `onRevision` with the folder's revision after something in it changed. It says nothing of who changed it: the caller
 * compares with the revision it wrote itself. A folder in the middle of a change (a file gone for a moment) is left for the
 * next event.
 */
export function watchProject(root: string, onRevision: (revision: string) => void): ProjectWatch {
  let timer: NodeJS.Timeout | undefined;
  let disposed = false;
  let shaders: FSWatcher | null = null;

  const read = async () => {
    // Another process is in the middle of a save: half of it would be taken for a change of its own.
    if (await isLocked(root)) {
      if (!disposed) touch();
      return;
    }
    shaders ??= watchFolder(join(root, SHADERS_FOLDER), touchShader);
    const files = await readProjectFiles(root).catch(() => null);
    if (files && !disposed) onRevision(revisionOf(files));
  };
  const readAfter = (ms: number) => {
    clearTimeout(timer);
    timer = setTimeout(() => void read(), ms);
  };
  const touch = () => readAfter(QUIET_MS);
  const touchShader = () => readAfter(SHADER_QUIET_MS);

  const folder = watchFolder(root, touch);
  shaders = watchFolder(join(root, SHADERS_FOLDER), touchShader);
  return {
    dispose: () => {
      disposed = true;
      clearTimeout(timer);
      folder?.close();
      shaders?.close();
    },
  };
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
