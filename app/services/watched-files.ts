import type { FileLayer } from './file-layer.ts';

/**
 * Wraps a file layer: counts written files, and throws when interrupted, so that an unfinished folder is removed as after a full
 * disk. Renames are not interrupted, because both must happen.
 */
export function watchedFiles(files: FileLayer, interrupted: AbortSignal | undefined, onWrite: (count: number) => void): FileLayer {
  let count = 0;
  return {
    ...files,
    writeNew: async (path, bytes) => {
      interrupted?.throwIfAborted();
      onWrite(++count);
      await files.writeNew(path, bytes);
    },
    makeFolder: async (path) => {
      interrupted?.throwIfAborted();
      await files.makeFolder(path);
    },
  };
}
