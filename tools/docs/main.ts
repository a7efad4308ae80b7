import { join } from 'node:path';
import { DEFINITIONS } from '../../nodes/generated/definitions.gen.ts';
import { writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { generatedPages } from './pages.ts';

/** Writes the generated pages of `docs/`, which are committed; a test fails when they are stale. */
export async function main(_args: readonly string[], { root }: ToolContext): Promise<number> {
  for (const [path, text] of Object.entries(generatedPages(DEFINITIONS))) {
    if (await writeIfChanged(join(root, path), text)) console.log(`changed: ${path}`);
  }
  return 0;
}
