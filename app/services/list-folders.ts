import { lstat, readdir, stat } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { HostOutput } from '../contract/contract.ts';
import { PROJECT_FILE } from './project-files.ts';

/** More folders than a person looks through. */
const MOST_FOLDERS = 1000;

/**
 * Lists the folders in a folder by name, for the folder browser: without hidden ones and without files. A folder that does not exist is
 * replaced by its nearest ancestor that does. One that cannot be read has none.
 *
 * @param path Absolute.
 */
export async function listFolders(path: string): Promise<HostOutput<'folder.list'>> {
  const folder = await nearestFolder(path);
  const above = dirname(folder);
  const entries = await readdir(folder, { withFileTypes: true }).catch(() => []);
  const seen = entries.filter(({ name }) => !name.startsWith('.')).sort((a, b) => a.name.localeCompare(b.name));
  const folders: { name: string; path: string; isProject: boolean }[] = [];
  for (const entry of seen) {
    if (folders.length === MOST_FOLDERS) break;
    const inside = join(folder, entry.name);
    const isFolder = entry.isDirectory() || (entry.isSymbolicLink() && (await isDirectory(inside)));
    if (isFolder) folders.push({ name: entry.name, path: inside, isProject: await isFile(join(inside, PROJECT_FILE)) });
  }
  return { path: folder, parent: above === folder ? null : above, folders };
}

async function nearestFolder(path: string): Promise<string> {
  for (let at = path; ; at = dirname(at)) if (at === dirname(at) || (await isDirectory(at))) return at;
}

async function isDirectory(path: string): Promise<boolean> {
  return (await stat(path).catch(() => null))?.isDirectory() ?? false;
}

async function isFile(path: string): Promise<boolean> {
  return (await lstat(path).catch(() => null))?.isFile() ?? false;
}
