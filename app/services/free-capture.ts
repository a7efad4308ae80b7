import { readdir } from 'node:fs/promises';
import { resolveInside } from './confine.ts';
import { writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { ASSETS_FOLDER } from './project-files.ts';
import { ensureScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';
import { withWorkLock } from './work-lock.ts';

/**
 * Runs a task that makes a capture, with a folder in `assets/` that is free: `NAME.capture`, or with a number. One process makes captures of the
 * same name at a time, because two would find the same folder free.
 *
 * @throws SCR060, SCR062, SCR066, SCR067
 */
export async function withFreeCapture<T>(root: string, name: string, files: FileLayer, task: (path: string) => Promise<T>): Promise<T> {
  const stem = stemOf(name);
  await ensureScrimFolder(root, files).catch((error: unknown) => Promise.reject(writeRefusal(error, root)));
  const lock = await resolveInside(root, `${SCRIM_FOLDER}/import-${stem}.lock`);
  return withWorkLock({ lock, files, doing: `is importing the capture ${stem} into ${root}` }, async () =>
    task(await freePath(root, stem)),
  );
}

/** A name of a file, of the name of a capture. */
function stemOf(name: string): string {
  const stem = name
    .replace(/[^A-Za-z0-9_-]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 80);
  return stem || 'capture';
}

async function freePath(root: string, stem: string): Promise<string> {
  const taken = new Set(await readdir(await resolveInside(root, ASSETS_FOLDER)).catch(() => []));
  for (let number = 1; ; number++) {
    const folder = `${stem}${number === 1 ? '' : `-${number}`}.capture`;
    if (!taken.has(folder)) return `${ASSETS_FOLDER}/${folder}`;
  }
}
