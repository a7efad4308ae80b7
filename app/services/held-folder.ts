import type { FileSink } from '../../export/bundle/bundle-page.ts';
import type { FileLayer } from './file-layer.ts';
import { type FolderMark, writePageFolder } from './page-folder.ts';

/** A folder that is written over several calls, and replaces an earlier one in one step. */
export interface HeldFolder {
  readonly sink: FileSink;
  /** Resolves when the folder is in place. @throws SCR060, SCR062 */
  complete(): Promise<void>;
  /** Resolves when all files are deleted. Never rejects. */
  discard(): Promise<void>;
}

/**
 * Begins a folder, as `writePageFolder` does.
 *
 * @throws SCR060, SCR061, SCR062
 */
export function holdFolder(out: string, files: FileLayer, mark: FolderMark): Promise<HeldFolder> {
  return new Promise((resolve, reject) => {
    const done: Promise<unknown> = writePageFolder(
      out,
      files,
      (sink) =>
        new Promise<true | null>((settle) => {
          resolve({
            sink,
            complete: async () => {
              settle(true);
              await done;
            },
            discard: async () => {
              settle(null);
              await done.catch(() => {});
            },
          });
        }),
      mark,
    );
    done.catch(reject);
  });
}
