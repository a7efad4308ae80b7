import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import type { ProjectFiles } from '../contract/contract.ts';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { isGone, OWNER, OWNER_PATTERN } from './owner.ts';
import { revisionOf } from './project-files.ts';
import { readText } from './read-file.ts';
import { ensureScrimFolder, listScrimFolder, SCRIM_FOLDER, temporaryIn } from './scrim-folder.ts';

/** Each window keeps its own, so that two on one project never take each other's away. */
const UNSAVED = new RegExp(`^unsaved-(${OWNER_PATTERN})-([0-9a-f]+)\\.json$`);

/** What a message can hold at most. */
const MAX_UNSAVED_BYTES = 512 * 2 ** 20;

/** Keeps unsaved work beside the project, where it survives a crash; null forgets it. */
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
 * The newest unsaved work that no living window minds and that differs from what is saved, or null. It is taken over: from now
 * on it is what the window `projectId` has unsaved. `isMinded` tells of windows of this process. Older work stays for the next time.
 */
export async function takeOverUnsaved(
  root: string,
  projectId: string,
  saved: ProjectFiles,
  isMinded: (projectId: string) => boolean,
  files: FileLayer,
): Promise<ProjectFiles | null> {
  for (const name of await abandoned(root, isMinded)) {
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

/** Names of files that no living window minds, newest first. */
async function abandoned(root: string, isMinded: (projectId: string) => boolean): Promise<readonly string[]> {
  const found: { readonly name: string; readonly touchedMs: number }[] = [];
  for (const name of await listScrimFolder(root)) {
    const [, owner, projectId] = UNSAVED.exec(name) ?? [];
    if (owner === undefined || projectId === undefined) continue;
    const entry = await lstat(join(root, SCRIM_FOLDER, name)).catch(() => null);
    if (!entry?.isFile()) continue;
    const minded = owner === OWNER ? isMinded(projectId) : !isGone(owner, entry.mtimeMs);
    if (!minded) found.push({ name, touchedMs: entry.mtimeMs });
  }
  return found.sort((a, b) => b.touchedMs - a.touchedMs).map(({ name }) => name);
}

function pathOf(projectId: string): string {
  return `${SCRIM_FOLDER}/unsaved-${OWNER}-${projectId}.json`;
}

/** The file is written whole or not at all, but people's tools may have touched it. */
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
