import { join } from 'node:path';
import { writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { findNodes } from './find-nodes.ts';
import { fontLibrary } from './font.ts';
import { isfDefinitions } from './isf.ts';
import { printDefinitions, printRecipes, printRuntimeFiles, printRuntimes } from './print.ts';
import { recipeProblems } from './recipe-problems.ts';
import { writeWorkers } from './workers.ts';

/**
 * Writes `nodes/generated/`: the registry of node types, made from folders so that nothing registers itself (ADR 4). The run fails if a
 * shader or recipe of the library has an error or a warning, but the registry is still written, without the shaders that cannot be read.
 */
export async function main(_args: readonly string[], context: ToolContext): Promise<number> {
  const { root } = context;
  const files = await findNodes(root);
  const found = { ...files, library: [...files.library, await fontLibrary()] };
  const folder = join(root, 'nodes', 'generated');
  const { definitions, problems: shaderProblems } = await isfDefinitions(found.library, context);
  const problems = [...shaderProblems, ...recipeProblems(found.recipes), ...(await writeWorkers(root, found))];
  for (const problem of problems) console.error(problem);
  await writeIfChanged(join(folder, 'definitions.gen.ts'), printDefinitions(found, definitions));
  await writeIfChanged(join(folder, 'recipes.gen.ts'), printRecipes(found));
  await writeIfChanged(join(folder, 'runtimes.gen.ts'), printRuntimes(found));
  await writeIfChanged(join(folder, 'runtime-files.gen.ts'), printRuntimeFiles(found));
  return problems.length === 0 ? 0 : 1;
}
