import type { Asset } from '../../graph/project.ts';
import type { ProgramCredit } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';

/** Whose works the nodes are, and the assets that they name: each work once, effects first, by title. */
export function collectCredits(nodes: readonly FlatNode[], assets: Readonly<Record<string, Asset>>): ProgramCredit[] {
  // A work that thousands of nodes use: their list grows in place, because a copy for each would take a time with their square.
  const found = new Map<string, ProgramCredit & { readonly nodes: string[] }>();
  const add = (key: string, { id }: FlatNode, work: Omit<ProgramCredit, 'nodes'>) => {
    if (work.credit === '' && work.licence === '') return;
    const nodes = found.get(key)?.nodes ?? [];
    nodes.push(id);
    found.set(key, { ...work, nodes });
  };
  for (const node of nodes) {
    const { type, title, credit = '', licence = '', params } = node.definition;
    add(type, node, { title, kind: 'effect', credit, licence });
    for (const [name, param] of Object.entries(params)) {
      const binding = param.type === 'asset' ? node.bindings.get(name) : undefined;
      const asset = binding && 'value' in binding && typeof binding.value === 'string' ? assets[binding.value] : undefined;
      if (asset) add(asset.path, node, { title: asset.path, kind: 'asset', credit: asset.credit ?? '', licence: asset.licence ?? '' });
    }
  }
  return [...found.values()].sort((a, b) => order(b.kind, a.kind) || order(a.title, b.title));
}

function order(a: string, b: string): number {
  return a < b ? -1 : a > b ? 1 : 0;
}
