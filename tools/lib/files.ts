import { mkdir, readdir, readFile, rename, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import process from 'node:process';

/** Folders that hold nothing written by hand, at any depth, beside those whose name starts with a dot. */
const SKIPPED_NAMES = new Set(['node_modules', 'dist', 'coverage']);

/**
 * Paths of all files below `folder`, relative to it, `/` between parts, sorted. `skip` leaves out whole folders by their
 * relative path. A missing folder has no files.
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

/** The file's text, or null where there is none. */
export async function readIfThere(path: string): Promise<string | null> {
  return readFile(path, 'utf8').catch(() => null);
}

/**
 * Writes only what differs, so that watchers and caches downstream stay quiet, and through a rename, so that a reader never
 * sees half a file. Returns whether it wrote.
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
