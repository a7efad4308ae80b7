import { readdir } from 'node:fs/promises';
import { basename, dirname, join, relative, sep } from 'node:path';
import { realFolder, resolveInside } from './confine.ts';
import { fillEmptyFolder } from './empty-folder.ts';
import { refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { changesBetween, listAssets, readProjectFiles, revisionOf } from './project-files.ts';
import { readAssetFile } from './read-asset.ts';
import { writeAll } from './transaction.ts';

const MAX_COPIES = 999;

export interface CopyExampleJob {
  /** Real path of the example. */
  readonly example: string;
  /** Folder for the copy; created if it does not exist. */
  readonly projectsDir: string;
  readonly files: FileLayer;
}

/** Whether a folder is one of the examples that come with Scrim, which are never overwritten. */
export async function isExample(root: string, examplesDir: string): Promise<boolean> {
  const folder = await realFolder(examplesDir).catch(() => null);
  if (folder === null) return false;
  const path = relative(folder, root);
  return path !== '' && !path.includes(sep) && path !== '..';
}

/**
 * Copies an example to the projects folder, as `NAME` or, if that is taken, `NAME-2`, `NAME-3`, …. Uses an earlier copy again while it is
 * unchanged. Returns the path of the copy.
 *
 * @throws SCR004, SCR005, SCR060, SCR061, SCR062
 */
export async function copyExample({ example, projectsDir, files }: CopyExampleJob): Promise<string> {
  const project = await readProjectFiles(example);
  const revision = revisionOf(project);
  for (let copy = 1; copy <= MAX_COPIES; copy++) {
    const path = join(projectsDir, copy === 1 ? basename(example) : `${basename(example)}-${copy}`);
    const names = await readdir(path).catch(() => []);
    if (names.length === 0) {
      return fillEmptyFolder(path, files, async (root) => {
        await copyAssets(example, root, files);
        await writeAll(root, changesBetween(null, project), files);
      });
    }
    const there = await readProjectFiles(path).catch(() => null);
    if (there !== null && revisionOf(there) === revision) return path;
  }
  throw refusal('SCR061', `${projectsDir} contains ${MAX_COPIES} copies of this example.`, 'Delete copies that you do not need.');
}

/** Copies `assets/` of a project into one without assets. */
export async function copyAssets(from: string, to: string, files: FileLayer): Promise<void> {
  for (const { path } of await listAssets(from)) {
    const target = await resolveInside(to, path);
    await files.makeFolder(dirname(target));
    await files.writeNew(target, await readAssetFile(from, path));
  }
}
