import { constants } from 'node:fs';
import { link, open, rename, rm } from 'node:fs/promises';
import { resolve } from 'node:path';
import process from 'node:process';
import { makeFolders } from './make-folders.ts';

/** File operations of a save. Injected, so that tests can make each of them fail. */
export interface FileLayer {
  /** Creates a file that must not exist, and resolves when its bytes are on the disk. */
  writeNew(path: string, bytes: Uint8Array): Promise<void>;
  /** Replaces the target atomically. */
  rename(from: string, to: string): Promise<void>;
  /** Creates a hard link. Fails if the name exists. */
  link(from: string, to: string): Promise<void>;
  /** Deletes a file or folder, if it exists. */
  remove(path: string): Promise<void>;
  makeFolder(path: string): Promise<void>;
  /** Resolves when the entries of the folder are on the disk. */
  syncFolder(path: string): Promise<void>;
}

export const NODE_FILES: FileLayer = {
  writeNew: async (path, bytes) => {
    const file = await open(path, 'wx');
    try {
      await file.writeFile(bytes);
      await file.sync();
    } finally {
      await file.close();
    }
  },
  rename,
  link,
  remove: (path) => rm(path, { recursive: true, force: true }),
  makeFolder: async (path) => {
    await makeFolders(resolve(path));
  },
  syncFolder: async (path) => {
    // Windows cannot open folders; NTFS journals the rename.
    if (process.platform === 'win32') return;
    const folder = await open(path, constants.O_RDONLY);
    try {
      await folder.sync();
    } finally {
      await folder.close();
    }
  },
};
