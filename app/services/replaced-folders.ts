import { lstat } from 'node:fs/promises';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { listScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

/** Number of the newest folders with replaced files that stay, however old they are. */
const NEWEST_KEPT = 5;

/** Time for which all folders with replaced files stay, however many there are. */
const KEPT_MS = 30 * 24 * 3600 * 1000;

const NAME = /^replaced-(\d{4}-\d\d-\d\dT\d\d)-(\d\d)-(\d\d\.\d{3}Z)$/;

/** Project path of the folder that keeps the files which a save at this moment replaces. Its name contains the time in UTC. */
export function replacedFolder(now: Date): string {
  return `${SCRIM_FOLDER}/replaced-${now.toISOString().replaceAll(':', '-')}`;
}

/**
 * Removes folders with replaced files that are older than 30 days, except the newest five. The time in the name counts, because copying or
 * moving a project changes the times of its files.
 */
export async function removeOldReplaced(root: string, now: Date, files: FileLayer): Promise<void> {
  const folders = (await listScrimFolder(root))
    .map((name) => ({ name, timeMs: timeOf(name) }))
    .filter(({ timeMs }) => !Number.isNaN(timeMs))
    .sort((a, b) => b.timeMs - a.timeMs);
  for (const { name, timeMs } of folders.slice(NEWEST_KEPT)) {
    if (now.getTime() - timeMs <= KEPT_MS) continue;
    const path = await resolveInside(root, `${SCRIM_FOLDER}/${name}`);
    if ((await lstat(path)).isDirectory()) await files.remove(path);
  }
}

/** The time in the name of a folder with replaced files, in milliseconds; NaN for other names. */
function timeOf(name: string): number {
  const parts = NAME.exec(name);
  return parts === null ? Number.NaN : Date.parse(parts.slice(1).join(':'));
}
