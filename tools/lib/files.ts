import { mkdir, readdir, readFile, rename, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import process from 'node:process';

/** Names of folders without source files, besides those that start with a dot. */
const SKIPPED_NAMES = new Set(['node_modules', 'dist', 'coverage']);

/**
 * Paths of all files in `folder`, relative to it, sorted. Empty if the folder is missing.
 *
 * @param skip Excludes folders by their relative path.
 */
export async function listFiles(folder: string, skip: (path: string) => boolean = () => false): Promise<string[]> {
  const found: string[] = [];
  await walk(folder, '', skip, found);
  return found.sort();
}

async function walk(folder: string, prefix: string, skip: (path: string) => boolean, found: string[]): Promise<void> {
  const entries = await readdir(join(folder, prefix), { withFileTypes: true }).catch(() => []);
  for (const entry of entries) {
    const path = prefix === '' ? entry.name : `${prefix}/${entry.name}`;
    if (entry.isFile()) found.push(path);
    else if (entry.isDirectory() && !isSkipped(entry.name) && !skip(path)) await walk(folder, path, skip, found);
  }
}

/** The text of a file; null if it does not exist. */
export async function readIfThere(path: string): Promise<string | null> {
  return readFile(path, 'utf8').catch(() => null);
}

/**
 * Writes a file only if it differs, so that watchers and caches are not triggered, and by a rename, so that readers never see a
 * partial file. Returns whether it wrote.
 */
export async function writeIfChanged(path: string, text: string): Promise<boolean> {
  if ((await readIfThere(path)) === text) return false;
  await mkdir(dirname(path), { recursive: true });
  const temporary = `${path}.${process.pid}.tmp`;
  await writeFile(temporary, text);
  await rename(temporary, path);
  return true;
}

function isSkipped(folder: string): boolean {
  return folder.startsWith('.') || SKIPPED_NAMES.has(folder);
}
