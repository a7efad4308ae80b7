import type { Capability, ProgramNeed } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';

/**
 * What the program asks of a session: what its nodes need, each capability once. A need "when sampled" counts only where the
 * node has work to do: the camera's picture as nothing but the background is the device's own affair. What is looked at counts,
 * because there would be nothing to see without; an export looks at nothing.
 */
export function collectNeeds(nodes: readonly FlatNode[], working: ReadonlySet<string>): ProgramNeed[] {
  const needs = new Map<Capability, ProgramNeed>();
  for (const { id, definition } of nodes) {
    for (const { capability, required, when, why, without } of definition.needs ?? []) {
      if (when === 'sampled' && !working.has(id)) continue;
      const known = needs.get(capability);
      if (!known) needs.set(capability, { capability, required, nodes: [id], why, without });
      else needs.set(capability, { ...known, required: known.required || required, nodes: [...known.nodes, id] });
    }
  }
  return [...needs.values()].sort((a, b) => (a.capability < b.capability ? -1 : 1));
}
