import { lstat } from 'node:fs/promises';
import { resolveInside } from './confine.ts';
import type { FileLayer } from './file-layer.ts';
import { listScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';

/** The newest of these folders stay, however old they are. */
const NEWEST_KEPT = 5;

/** All folders stay for this long, however many there are. */
const KEPT_MS = 30 * 24 * 3600 * 1000;

const NAME = /^replaced-(\d{4}-\d\d-\d\dT\d\d)-(\d\d)-(\d\d\.\d{3}Z)$/;

/** Project path of the folder for what a save at this moment writes over. Its name holds the time in UTC. */
export function replacedFolder(now: Date): string {
  return `${SCRIM_FOLDER}/replaced-${now.toISOString().replaceAll(':', '-')}`;
}

/**
 * Removes the folders that saves have kept and that are older than 30 days, except the newest five. The time in the name counts: copying
 * or moving a project changes the times of its files.
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

/** NaN for names of other things. */
function timeOf(name: string): number {
  const parts = NAME.exec(name);
  return parts === null ? Number.NaN : Date.parse(parts.slice(1).join(':'));
}
