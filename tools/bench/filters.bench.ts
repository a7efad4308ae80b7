import { LIBRARY } from '../../app/services/compile-project.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { benchesInCopies } from './in-copies.ts';

/**
 * Lowerings of effects that the page draws. The worker of a CPU filter does not block the page, so only the drawing of such a filter is
 * measured.
 */
const DRAWN: ReadonlySet<NodeDefinition['lowering']['kind']> = new Set(['image', 'cpu']);
const EFFECTS = ['filter/', 'operator/'];

/** Measures every filter and composite in plain copies. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const types = [...LIBRARY.types()].filter((type) => {
    const kind = LIBRARY.definition(type)?.lowering.kind;
    return EFFECTS.some((start) => type.startsWith(start)) && kind !== undefined && DRAWN.has(kind);
  });
  return benchesInCopies(root, types.sort());
}
