import { dirname } from 'node:path';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { listAssets } from './project-files.ts';
import { readAssetFile } from './read-asset.ts';

/** Copies `assets/` of a project into one without assets. */
export async function copyAssets(from: string, to: string, files: FileLayer): Promise<void> {
  for (const { path } of await listAssets(from)) {
    const target = await resolveInside(to, path);
    await files.makeFolder(dirname(target));
    await files.writeNew(target, await readAssetFile(from, path));
  }
}
