import type { FileLayer } from './file-layer.ts';

/**
 * Files that tell how many were written, and refuse to write more once the person has had enough: what is half done is then taken
 * back as on a full disk. Renames go on, because half of two is worse than both.
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
