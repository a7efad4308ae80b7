import { readdir, rm, stat, utimes } from 'node:fs/promises';
import { join } from 'node:path';
import type { AssetCache } from '../../export/bundle/assets/model-cache.ts';
import { MAX_ASSET_BYTES } from '../contract/call-parts.ts';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { readBytes } from './read-file.ts';
import { ensureScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

const CACHE_FOLDER = `${SCRIM_FOLDER}/cache`;

/** Entries that no export has used for this time are deleted. */
const UNUSED_MS = 30 * 24 * 3600 * 1000;

/** Cache of compressed assets in the `.scrim` folder of the project, which version control ignores. It can be deleted at any time. */
export function createAssetCache(root: string, files: FileLayer): AssetCache {
  const pathOf = (name: string) => resolveInside(root, `${CACHE_FOLDER}/${name}`);
  return {
    read: async (name) => {
      const path = await pathOf(name);
      const bytes = await readBytes(path, MAX_ASSET_BYTES).catch(() => null);
      const now = new Date();
      if (bytes) await utimes(path, now, now).catch(() => {});
      return bytes;
    },
    write: async (name, bytes) => {
      await ensureScrimFolder(root, files);
      await files.makeFolder(await resolveInside(root, CACHE_FOLDER));
      await removeUnused(join(root, CACHE_FOLDER));
      await files.writeNew(await pathOf(name), bytes);
    },
  };
}

async function removeUnused(folder: string): Promise<void> {
  for (const name of await readdir(folder)) {
    const path = join(folder, name);
    const { mtimeMs } = await stat(path);
    if (Date.now() - mtimeMs > UNUSED_MS) await rm(path, { force: true });
  }
}
