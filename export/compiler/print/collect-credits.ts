import type { Asset } from '../../graph/project.ts';
import type { ProgramCredit } from '../../program/program-credit.ts';
import type { FlatNode } from '../flat-graph.ts';

/** Credits of the nodes' effects and of the assets that they use, without duplicates: effects first, by title. */
export function collectCredits(nodes: readonly FlatNode[], assets: Readonly<Record<string, Asset>>): ProgramCredit[] {
  // A work may have thousands of users, so its list grows in place; copying it for each would take quadratic time.
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
