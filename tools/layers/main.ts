import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { checkFiles } from './check.ts';

/** Checks the import directions of docs/ARCHITECTURE.md and the rules of `table.ts` for all code of the repository. */
export async function main(_args: readonly string[], { root }: ToolContext): Promise<number> {
  const paths = (await listFiles(root, (path) => path === 'tests/output')).filter((path) => /\.(ts|tsx|js|jsx|mjs|cjs)$/.test(path));
  const files = await Promise.all(paths.map(async (path) => ({ path, text: await readFile(join(root, path), 'utf8') })));
  const problems = checkFiles(files);
  for (const problem of problems) console.error(problem);
  console.log(problems.length === 0 ? `Layers: ${files.length} files keep to the table.` : `Layers: ${problems.length} problems.`);
  return problems.length === 0 ? 0 : 1;
}
