import { join } from 'node:path';
import { writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { findNodes } from './find-nodes.ts';
import { isfDefinitions } from './isf.ts';
import { printDefinitions, printRuntimeFiles, printRuntimes } from './print.ts';

/** Writes `nodes/generated/`: the registry of node types, made from folders so that nothing registers itself (ADR 4). */
export async function main(_args: readonly string[], { root }: ToolContext): Promise<number> {
  const found = await findNodes(root);
  const folder = join(root, 'nodes', 'generated');
  const definitions = await isfDefinitions(found.library);
  await writeIfChanged(join(folder, 'definitions.gen.ts'), printDefinitions(found, definitions));
  await writeIfChanged(join(folder, 'runtimes.gen.ts'), printRuntimes(found.nodes));
  await writeIfChanged(join(folder, 'runtime-files.gen.ts'), printRuntimeFiles(found.nodes));
  return 0;
}
