import { constants } from 'node:fs';
import { link, open, rename, rm } from 'node:fs/promises';
import { resolve } from 'node:path';
import process from 'node:process';
import { makeFolders } from './make-folders.ts';

/** The file operations that a save is made of; handed in, so that a test can break any one of them. */
export interface FileLayer {
  /** Makes a file that was not there, and returns when its bytes are on the disk. */
  writeNew(path: string, bytes: Uint8Array): Promise<void>;
  /** Replaces what is there, in one step. */
  rename(from: string, to: string): Promise<void>;
  /** A second name for the same bytes; fails where the name is taken. */
  link(from: string, to: string): Promise<void>;
  /** A missing file is fine. */
  remove(path: string): Promise<void>;
  makeFolder(path: string): Promise<void>;
  /** Returns when the folder's own entries are on the disk. */
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
    // Windows cannot open a folder; there, NTFS journals the rename.
    if (process.platform === 'win32') return;
    const folder = await open(path, constants.O_RDONLY);
    try {
      await folder.sync();
    } finally {
      await folder.close();
    }
  },
};
