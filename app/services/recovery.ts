import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import type { ProjectFiles } from '../contract/contract.ts';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER, OWNER_PATTERN } from './owner.ts';
import { revisionOf } from './project-files.ts';
import { readText } from './read-file.ts';
import { ensureScrimFolder, listScrimFolder, SCRIM_FOLDER, temporaryIn } from './scrim-folder.ts';

/** Matches recovery files. Each window has its own, so that two windows of one project do not overwrite each other’s. */
const UNSAVED = new RegExp(`^unsaved-(${OWNER_PATTERN})-([0-9a-f]+)\\.json$`);

/** Maximum size of a recovery file. */
const MAX_UNSAVED_BYTES = 512 * 2 ** 20;

/** Stores unsaved changes beside the project; null deletes them. */
export async function keepUnsaved(root: string, projectId: string, work: ProjectFiles | null, files: FileLayer): Promise<void> {
  const target = await resolveInside(root, pathOf(projectId));
  if (work === null) {
    await files.remove(target);
    return;
  }
  await ensureScrimFolder(root, files);
  const temporary = temporaryIn(root);
  try {
    await files.writeNew(temporary, new TextEncoder().encode(JSON.stringify(work)));
    await files.rename(temporary, target);
  } catch (error) {
    await files.remove(temporary);
    throw error;
  }
}

/**
 * Takes over the newest unsaved changes that no running window owns and that differ from the saved files; null if there are none.
 * They belong to the window `projectId` from then on. `isOwned` tells whether a window of this process owns a file. Older ones are
 * offered next time.
 */
export async function takeOverUnsaved(
  root: string,
  projectId: string,
  saved: ProjectFiles,
  isOwned: (projectId: string) => boolean,
  files: FileLayer,
): Promise<ProjectFiles | null> {
  for (const name of await abandoned(root, isOwned)) {
    const path = join(root, SCRIM_FOLDER, name);
    const work = parse(await readText(await resolveInside(root, `${SCRIM_FOLDER}/${name}`), MAX_UNSAVED_BYTES).catch(() => ''));
    if (work === null) continue;
    if (revisionOf(work) === revisionOf(saved)) {
      await files.remove(path).catch(() => {});
      continue;
    }
    await files.rename(path, join(root, pathOf(projectId))).catch(() => {});
    return work;
  }
  return null;
}

/** File names of unsaved changes that no running window owns, newest first. */
async function abandoned(root: string, isOwned: (projectId: string) => boolean): Promise<readonly string[]> {
  const found: { readonly name: string; readonly touchedMs: number }[] = [];
  for (const name of await listScrimFolder(root)) {
    const [, owner, projectId] = UNSAVED.exec(name) ?? [];
    if (owner === undefined || projectId === undefined) continue;
    const entry = await lstat(join(root, SCRIM_FOLDER, name)).catch(() => null);
    if (!entry?.isFile()) continue;
    const minded = owner === OWNER ? isOwned(projectId) : !isGone(owner, entry.mtimeMs);
    if (!minded) found.push({ name, touchedMs: entry.mtimeMs });
  }
  return found.sort((a, b) => b.touchedMs - a.touchedMs).map(({ name }) => name);
}

function pathOf(projectId: string): string {
  return `${SCRIM_FOLDER}/unsaved-${OWNER}-${projectId}.json`;
}

/** Parses a recovery file. Files are written atomically, but other programs may have changed them. */
function parse(text: string): ProjectFiles | null {
  try {
    const work = JSON.parse(text) as ProjectFiles;
    const strings = [work.project, ...Object.values(work.sources)];
    const right = strings.every((s) => typeof s === 'string') && (work.layout === null || typeof work.layout === 'string');
    return right ? { project: work.project, layout: work.layout, sources: work.sources } : null;
  } catch {
    return null;
  }
}
