import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { listFiles, writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { checkStrings } from './check.ts';
import { printTable, readStrings, STRINGS_TABLE, type UserString } from './read-strings.ts';

/** Writes the table of every string that a user reads, and reports the strings that break a rule of their kind. */
export async function main(_args: readonly string[], { root }: ToolContext): Promise<number> {
  const strings = await collectStrings(root);
  if (await writeIfChanged(join(root, STRINGS_TABLE), printTable(strings))) console.log(`changed: ${STRINGS_TABLE}`);
  const problems = checkStrings(strings);
  for (const problem of problems) console.error(problem);
  console.log(`Strings: ${strings.length} in ${new Set(strings.map(({ file }) => file)).size} files, ${problems.length} problems.`);
  return problems.length === 0 ? 0 : 1;
}

/** The strings of all product files below `root`, sorted by file and position. */
export async function collectStrings(root: string): Promise<UserString[]> {
  const strings: UserString[] = [];
  for (const path of await listFiles(root, (folder) => folder === 'tests' || folder === 'nodes/generated')) {
    if (isProduct(path)) strings.push(...readStrings(path, await readFile(join(root, path), 'utf8')));
  }
  return strings;
}

/** Code, examples and recipes that a user meets: no tests, benches or tools. */
function isProduct(path: string): boolean {
  if (/\.(test|page|bench|d)\.tsx?$|\.gen\.ts$/.test(path)) return false;
  if (/^(app|export|nodes|renderer)\/.*\.tsx?$/.test(path)) return true;
  if (/^(?:examples|shader-library\/recipes)\/.*\/project\.scrim\.json$/.test(path)) return true;
  return /^shader-library\/.*\.(fs|glsl)$/.test(path) && !path.startsWith('shader-library/chunks/');
}
