import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { listFiles, writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { readMasters, syncCopies } from './copies.ts';

/** `npm run sync-chunks`: writes the functions of `shader-library/chunks/isf/` into the ISF files that hold copies of them. */
export async function main(_args: readonly string[], { root }: ToolContext): Promise<number> {
  const library = join(root, 'shader-library');
  const read = (path: string): Promise<string> => readFile(join(library, path), 'utf8');
  const paths = await listFiles(library);
  const chunks = paths.filter((path) => path.startsWith('chunks/isf/'));
  const masters = readMasters(Object.fromEntries(await Promise.all(chunks.map(async (path) => [path, await read(path)] as const))));
  for (const path of paths.filter((name) => name.endsWith('.fs'))) {
    if (await writeIfChanged(join(library, path), syncCopies(await read(path), masters))) console.log(`changed: shader-library/${path}`);
  }
  return 0;
}
