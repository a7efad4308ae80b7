import type { Capability, Need, ParamValue } from '../../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from '../schedule/slot-allocator.ts';

/**
 * The program's needs: those of its nodes, one per capability. A need “when sampled” counts only if the node has an operation; the camera
 * image as mere background needs no feature. Needs of viewed layers count, but exports view none.
 */
export function collectNeeds(nodes: readonly FlatNode[], working: ReadonlySet<string>): ProgramNeed[] {
  const needs = new Map<Capability, ProgramNeed>();
  const isAlone = nodes.filter((node) => isOriginalLayer(node)).every((node) => needsOf(node).some(({ required }) => required === 'alone'));
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

/** Whether the node outputs a layer that is not made from other layers. */
function isOriginalLayer({ definition, inputs }: FlatNode): boolean {
  const makesLayer = Object.values(definition.outputs).some(({ type }) => type === 'layer');
  return makesLayer && !Object.entries(definition.inputs).some(([name, { type }]) => type === 'layer' && inputs.has(name));
}

function structureValue(node: FlatNode, name: string): ParamValue | undefined {
  const param = node.definition.params[name];
  return param && startValue(node, name, param);
}
