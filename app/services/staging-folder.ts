import { mkdtemp, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { writeRefusal } from './file-errors.ts';
import { hasEnded, OWNER, OWNER_PATTERN } from './owner.ts';

const PREFIX = 'scrim-photographs-';
const NAME = new RegExp(`^${PREFIX}(${OWNER_PATTERN})-`);

/** Makes a folder for photographs that are not packed yet, among the temporary files. @throws SCR060, SCR062 */
export async function makeStagingFolder(): Promise<string> {
  return mkdtemp(join(tmpdir(), `${PREFIX}${OWNER}-`)).catch((error: unknown) => {
    throw writeRefusal(error, tmpdir());
  });
}

/** Deletes the folders of processes that ended without deleting them, as when they were killed. Never rejects. */
export async function sweepStagingFolders(): Promise<void> {
  const names = await readdir(tmpdir()).catch(() => []);
  for (const name of names) {
    const owner = NAME.exec(name)?.[1];
    if (owner !== undefined && hasEnded(owner)) await rm(join(tmpdir(), name), { recursive: true, force: true }).catch(() => {});
  }
}
