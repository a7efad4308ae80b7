import { createHash } from 'node:crypto';
import { lstat, readdir } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { isChunkFile, isShaderFile } from '../../export/graph/document-names.ts';
import type { OpenProject, ProjectFiles } from '../contract/contract.ts';
import { isPlainName, realFolder, resolveInside } from './confine.ts';
import { errorCode, readRefusal, refusal } from './file-errors.ts';
import { readText } from './read-file.ts';

export const PROJECT_FILE = 'project.scrim.json';
export const LAYOUT_FILE = 'project.layout.json';
export const SHADERS_FOLDER = 'shaders';
/** Folder of chunks, which techniques include. */
export const CHUNKS_FOLDER = `${SHADERS_FOLDER}/chunks`;
export const ASSETS_FOLDER = 'assets';

/** Maximum size of the project and layout file, as in the contract. */
export const MAX_DOCUMENT_BYTES = 64 * 2 ** 20;
export const MAX_SHADER_BYTES = 4 * 2 ** 20;

/** Limit for all shaders together. They are sent as one message and held in memory several times. */
const MAX_SHADERS_BYTES = 64 * 2 ** 20;

/** Limit of the contract for project paths. It also ends the walk through endlessly nested folders. */
const MAX_PATH_LENGTH = 512;

/**
 * Finds a project folder by its path or that of its project file.
 *
 * @throws SCR004
 */
export async function findProject(path: string): Promise<string> {
  const absolute = resolve(path);
  const found = await lstat(absolute).catch((error: unknown) => {
    throw readRefusal(error, path);
  });
  const root = await realFolder(found.isFile() ? dirname(absolute) : absolute);
  const project = await lstat(join(root, PROJECT_FILE)).catch(() => null);
  if (project) return root;
  throw refusal('SCR004', `${path} is not a Scrim project: it has no ${PROJECT_FILE}.`, 'Choose the folder that holds it.');
}

/**
 * Reads the files of a project.
 *
 * @throws SCR004, SCR005
 */
export async function readProjectFiles(root: string): Promise<ProjectFiles> {
  const project = await readProjectText(root, PROJECT_FILE, MAX_DOCUMENT_BYTES);
  if (project === null) throw refusal('SCR004', `${PROJECT_FILE} is missing from ${root}.`);
  const sources = await readShaders(root);
  return { project, layout: await readProjectText(root, LAYOUT_FILE, MAX_DOCUMENT_BYTES), sources };
}

/** Number of shaders read at once: few enough to check their sum before memory runs out, enough to use the disk well. */
const SHADERS_AT_ONCE = 16;

async function readShaders(root: string): Promise<Record<string, string>> {
  const folders = [SHADERS_FOLDER, ...(await listChunkFolders(root))];
  const listed = await Promise.all(folders.map(async (folder) => (await listNames(root, folder)).map((name) => `${folder}/${name}`)));
  const names = listed.flat().map((path) => path.slice(SHADERS_FOLDER.length + 1));
  const wanted = names.filter(isShaderFile);
  const sources: Record<string, string> = {};
  let length = 0;
  for (let start = 0; start < wanted.length; start += SHADERS_AT_ONCE) {
    const batch = wanted.slice(start, start + SHADERS_AT_ONCE);
    const texts = await Promise.all(batch.map((name) => readProjectText(root, `${SHADERS_FOLDER}/${name}`, MAX_SHADER_BYTES)));
    for (const [i, text] of texts.entries()) {
      const name = batch[i];
      if (text === null || name === undefined) continue;
      sources[name] = text;
      length += text.length;
    }
    if (length > MAX_SHADERS_BYTES) {
      throw refusal('SCR005', `The files in ${join(root, SHADERS_FOLDER)} have more than ${MAX_SHADERS_BYTES / 2 ** 20} MB in total.`);
    }
  }
  return sources;
}

/** The revision of a project: a hash of all texts. */
export function revisionOf({ project, layout, sources }: ProjectFiles): string {
  const shaders = Object.entries(sources).sort(([a], [b]) => (a < b ? -1 : 1));
  return createHash('sha256')
    .update(JSON.stringify([project, layout, shaders]))
    .digest('hex');
}

/** The files to write (bytes) or delete (null), by project path, to change a folder from `current` to `next`. */
export function changesBetween(current: ProjectFiles | null, next: ProjectFiles): Map<string, Uint8Array | null> {
  const before = current ? texts(current) : new Map<string, string>();
  const after = texts(next);
  const changes = new Map<string, Uint8Array | null>();
  for (const [path, text] of after) if (before.get(path) !== text) changes.set(path, new TextEncoder().encode(text));
  for (const path of before.keys()) if (!after.has(path)) changes.set(path, null);
  return changes;
}

function texts({ project, layout, sources }: ProjectFiles): Map<string, string> {
  const all = new Map([[PROJECT_FILE, project]]);
  if (layout !== null) all.set(LAYOUT_FILE, layout);
  for (const [name, text] of Object.entries(sources)) {
    if (!isShaderFile(name)) throw refusal('SCR031', `${JSON.stringify(name)} is not a valid name for a shader file.`);
    all.set(`${SHADERS_FOLDER}/${name}`, text);
  }
  return all;
}

/** Files in `assets/`, sorted. Omits links, hidden files, and names that `resolveInside` rejects. */
export async function listAssets(root: string): Promise<OpenProject['assetFiles']> {
  const found: OpenProject['assetFiles'] = [];
  const walk = async (folder: string) => {
    // Folders that cannot be read, or disappear meanwhile, count as missing. Nodes that use their files report it.
    for (const entry of await readdir(await resolveInside(root, folder), { withFileTypes: true }).catch(() => [])) {
      if (entry.name.startsWith('.') || !isPlainName(entry.name)) continue;
      const path = `${folder}/${entry.name}`;
      if (path.length > MAX_PATH_LENGTH) continue;
      if (entry.isDirectory()) await walk(path);
      else if (entry.isFile()) {
        const file = await lstat(join(root, path)).catch(() => null);
        if (file) found.push({ path, bytes: file.size });
      }
    }
  };
  // A missing folder or a link has no assets. The project opens, and nodes that use them report it.
  if (await isRealFolder(join(root, ASSETS_FOLDER))) await walk(ASSETS_FOLDER);
  return found.sort((a, b) => (a.path < b.path ? -1 : 1));
}

/** Lists the folder `shaders/chunks` and its subfolders, without links. */
export async function listChunkFolders(root: string): Promise<string[]> {
  const folders: string[] = [];
  if (await isRealFolder(join(root, CHUNKS_FOLDER))) folders.push(CHUNKS_FOLDER);
  // The loop also visits elements that are appended during it.
  for (const folder of folders) {
    const entries = await readdir(await resolveInside(root, folder), { withFileTypes: true }).catch(() => []);
    const inside = entries.filter((entry) => entry.isDirectory()).map(({ name }) => `${folder}/${name}`);
    // Skips folders that cannot contain chunks, such as endlessly nested ones.
    folders.push(...inside.filter((path) => isChunkFile(`${path.slice(SHADERS_FOLDER.length + 1)}/a.glsl`)));
  }
  return folders;
}

async function isRealFolder(path: string): Promise<boolean> {
  return lstat(path).then(
    (found) => found.isDirectory(),
    () => false,
  );
}

async function listNames(root: string, folder: string): Promise<string[]> {
  try {
    const entries = await readdir(await resolveInside(root, folder), { withFileTypes: true });
    return entries.filter((entry) => entry.isFile()).map((entry) => entry.name);
  } catch (error) {
    if (errorCode(error) === 'ENOENT') return [];
    throw errorCode(error) === undefined ? error : readRefusal(error, join(root, folder));
  }
}

/** Reads a text file of the project; null if it does not exist. */
async function readProjectText(root: string, path: string, maxBytes: number): Promise<string | null> {
  const absolute = await resolveInside(root, path);
  return readText(absolute, maxBytes).catch((error: unknown) => {
    if (errorCode(error) === 'ENOENT') return null;
    throw errorCode(error) === undefined ? error : readRefusal(error, absolute);
  });
}
