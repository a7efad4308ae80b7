import { readFile } from 'node:fs/promises';
import type { ProjectFiles } from '../contract/contract.ts';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { revisionOf } from './project-files.ts';
import { ensureScrimFolder, SCRIM_FOLDER, temporaryIn } from './scrim-folder.ts';

const RECOVERY = `${SCRIM_FOLDER}/unsaved.json`;

/** Keeps unsaved work beside the project, where it survives a crash; null forgets it. */
export async function keepUnsaved(root: string, work: ProjectFiles | null, files: FileLayer): Promise<void> {
  const target = await resolveInside(root, RECOVERY);
  if (work === null) {
    await files.remove(target);
    return;
  }
  await ensureScrimFolder(root, files);
  const temporary = temporaryIn(root, 'unsaved');
  try {
    await files.writeNew(temporary, new TextEncoder().encode(JSON.stringify(work)));
    await files.rename(temporary, target);
  } catch (error) {
    await files.remove(temporary);
    throw error;
  }
}

/** Unsaved work that differs from what is saved, or null. */
export async function findUnsaved(root: string, saved: ProjectFiles): Promise<ProjectFiles | null> {
  const text = await readFile(await resolveInside(root, RECOVERY), 'utf8').catch(() => null);
  if (text === null) return null;
  const work = parse(text);
  return work !== null && revisionOf(work) !== revisionOf(saved) ? work : null;
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
