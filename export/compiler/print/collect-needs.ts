import type { Capability, Need, ParamValue } from '../../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from '../schedule/slot-allocator.ts';

/**
 * What the program asks of a session: what its nodes need, each capability once. A need "when sampled" counts only where the
 * node has work to do: the camera's picture as nothing but the background is the device's own affair. What is looked at counts,
 * because there would be nothing to see without; an export looks at nothing.
 */
export function collectNeeds(nodes: readonly FlatNode[], working: ReadonlySet<string>): ProgramNeed[] {
  const needs = new Map<Capability, ProgramNeed>();
  const isAlone = nodes.filter((node) => bringsPicture(node)).every((node) => needsOf(node).some(({ required }) => required === 'alone'));
  for (const node of nodes) {
    const { id } = node;
    for (const { capability, required: demand, when, why, without } of needsOf(node)) {
      if (when === 'sampled' && !working.has(id)) continue;
      const required = demand === 'alone' ? isAlone : demand;
      const known = needs.get(capability);
      if (!known) needs.set(capability, { capability, required, nodes: [id], why, without });
      else needs.set(capability, { ...known, required: known.required || required, nodes: [...known.nodes, id] });
    }
  }
  return [...needs.values()].sort((a, b) => (a.capability < b.capability ? -1 : 1));
}

function needsOf(node: FlatNode): readonly Need[] {
  return (node.definition.needs ?? []).filter(({ where }) => !where || structureValue(node, where.param) === where.is);
}

/** Shows something that is not made of other layers. */
function bringsPicture({ definition, inputs }: FlatNode): boolean {
  const makesLayer = Object.values(definition.outputs).some(({ type }) => type === 'layer');
  return makesLayer && !Object.entries(definition.inputs).some(([name, { type }]) => type === 'layer' && inputs.has(name));
}

function structureValue(node: FlatNode, name: string): ParamValue | undefined {
  const param = node.definition.params[name];
  return param && startValue(node, name, param);
}
