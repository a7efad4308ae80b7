import { join } from 'node:path';
import { DEFINITIONS } from '../../nodes/generated/definitions.gen.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { diagnosticsPage } from './diagnostics-page.ts';
import { nodesPage } from './nodes-page.ts';

/** Writes the generated pages of `docs/`, which are committed; a test fails when they are stale. */
export async function main(_args: readonly string[], { root }: ToolContext): Promise<number> {
  for (const [path, text] of Object.entries(generatedPages(DEFINITIONS))) {
    if (await writeIfChanged(join(root, path), text)) console.log(`changed: ${path}`);
  }
  return 0;
}

/** The generated pages: path in the repository → text. */
export function generatedPages(definitions: readonly NodeDefinition[]): Readonly<Record<string, string>> {
  return {
    'docs/nodes.md': nodesPage(definitions),
    'docs/diagnostics.md': diagnosticsPage(),
  };
}
