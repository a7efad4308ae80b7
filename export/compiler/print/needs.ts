import type { ParamValue } from '../../graph/project.ts';
import type { Capability, ProgramNeed } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from '../schedule/slots.ts';

/**
 * What the program asks of a session: what its nodes need, each capability once. A need "when sampled" counts only where the
 * node has work to do: the camera's picture as nothing but the background is the device's own affair. What is looked at counts,
 * because there would be nothing to see without; an export looks at nothing.
 */
export function collectNeeds(nodes: readonly FlatNode[], working: ReadonlySet<string>): ProgramNeed[] {
  const needs = new Map<Capability, ProgramNeed>();
  for (const node of nodes) {
    const { id, definition } = node;
    for (const { capability, required, when, where, why, without } of definition.needs ?? []) {
      if (when === 'sampled' && !working.has(id)) continue;
      if (where && structureValue(node, where.param) !== where.is) continue;
      const known = needs.get(capability);
      if (!known) needs.set(capability, { capability, required, nodes: [id], why, without });
      else needs.set(capability, { ...known, required: known.required || required, nodes: [...known.nodes, id] });
    }
  }
  return [...needs.values()].sort((a, b) => (a.capability < b.capability ? -1 : 1));
}

function structureValue(node: FlatNode, name: string): ParamValue | undefined {
  const param = node.definition.params[name];
  return param && startValue(node, name, param);
}
