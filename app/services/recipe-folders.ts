import { lstat, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import type { HostInput, HostOutput } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { isPlainName, realFolder } from './confine.ts';
import { fillEmptyFolder } from './empty-folder.ts';
import { refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { changesBetween, readProjectFiles } from './project-files.ts';
import { writeAll } from './transaction.ts';

/** Folder of recipes in the projects folder. */
const RECIPES_FOLDER = 'recipes';
/** Folder of removed recipes, beside the others. Hidden, so that it is not listed. */
const REMOVED_FOLDER = '.removed';
/** More recipes than a person looks through. */
const MOST_RECIPES = 500;

type ListedRecipe = HostOutput<'recipe.list'>[number];

/** Lists the recipes of the user by name. One that cannot be read comes with the reason. */
export async function listRecipes(projectsDir: string): Promise<ListedRecipe[]> {
  const folder = join(projectsDir, RECIPES_FOLDER);
  const entries = await readdir(folder, { withFileTypes: true }).catch(() => []);
  const names = entries.filter((entry) => entry.isDirectory() && !entry.name.startsWith('.')).map(({ name }) => name);
  return Promise.all(
    names
      .sort()
      .slice(0, MOST_RECIPES)
      .map((name) => readRecipe(join(folder, name), name)),
  );
}

async function readRecipe(path: string, name: string): Promise<ListedRecipe> {
  try {
    return { name, path, files: await readProjectFiles(await realFolder(path)), problem: null };
  } catch (error) {
    if (!(error instanceof HostError)) throw error;
    return { name, path, files: null, problem: error.diagnostic };
  }
}

/**
 * Saves a recipe into a new folder. Returns its path.
 *
 * @throws SCR060, SCR061 if there is one of this name, SCR062
 */
export async function saveRecipe(projectsDir: string, { name, files: texts }: HostInput<'recipe.save'>, files: FileLayer): Promise<string> {
  return fillEmptyFolder(join(projectsDir, RECIPES_FOLDER, name), files, (root) =>
    writeAll(root, changesBetween(null, { ...texts, sources: {} }), files),
  );
}

/**
 * Moves the folder of a recipe to those of removed recipes. Returns its new path.
 *
 * @throws SCR004 if there is none of this name, SCR062
 */
export async function removeRecipe(projectsDir: string, name: string, files: FileLayer): Promise<string> {
  const folder = join(projectsDir, RECIPES_FOLDER);
  const path = join(folder, name);
  const found = isPlainName(name) && !name.startsWith('.') && !name.includes('/') ? await lstat(path).catch(() => null) : null;
  if (!found?.isDirectory()) throw refusal('SCR004', `There is no recipe ${JSON.stringify(name)}.`);
  try {
    const removed = join(folder, REMOVED_FOLDER);
    await files.makeFolder(removed);
    const taken = new Set(await readdir(removed));
    let free = name;
    for (let number = 2; taken.has(free); number++) free = `${name}-${number}`;
    await files.rename(path, join(removed, free));
    return join(removed, free);
  } catch (error) {
    throw writeRefusal(error, path);
  }
}
