import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { diagnosticsPage } from './diagnostics-page.ts';
import { nodesPage } from './nodes-page.ts';

/** The generated pages: path in the repository → text. */
export function generatedPages(definitions: readonly NodeDefinition[]): Readonly<Record<string, string>> {
  return {
    'docs/nodes.md': nodesPage(definitions),
    'docs/diagnostics.md': diagnosticsPage(),
  };
}
