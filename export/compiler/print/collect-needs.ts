import type { Capability, Need, ParamValue } from '../../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../../program/needs.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from '../schedule/slot-allocator.ts';

/**
 * The program's needs: those of its nodes, one per capability. A need “when sampled” counts only if the node has an operation; the camera
 * image as mere background needs no feature. Needs of viewed layers count, but exports view none.
 */
export function collectNeeds(nodes: readonly FlatNode[], working: ReadonlySet<string>): ProgramNeed[] {
  const needs = new Map<Capability, ProgramNeed>();
  const isAlone = nodes.filter((node) => isOriginalLayer(node)).every((node) => needsOf(node).some(({ required }) => required === 'alone'));
  const depthType = depthTypeOf(nodes);
  for (const node of nodes) {
    const { id } = node;
    for (const { capability, required: demand, when, why, without } of needsOf(node)) {
      if (when === 'sampled' && !working.has(id)) continue;
      const required = demand === 'alone' ? isAlone : demand;
      const known = needs.get(capability);
      if (!known) needs.set(capability, { capability, required, nodes: [id], why, without, ...(capability === 'depth' ? depthType : {}) });
      else {
        const withoutByNode = without === known.without ? known.withoutByNode : { ...known.withoutByNode, [id]: without };
        const merged = { ...known, required: known.required || required, nodes: [...known.nodes, id] };
        needs.set(capability, withoutByNode ? { ...merged, withoutByNode } : merged);
      }
    }
  }
  return [...needs.values()].sort((a, b) => (a.capability < b.capability ? -1 : 1));
}

/** The kind of depth to request: `raw` if some nodes read room depth and none of them wants it smooth. */
function depthTypeOf(nodes: readonly FlatNode[]): { readonly depthType?: 'raw' } {
  const readers = nodes.flatMap(({ definition, inputs }) =>
    Object.entries(definition.inputs).flatMap(([name, port]) => (port.type === 'depth' && inputs.has(name) ? [port] : [])),
  );
  const own = nodes.flatMap((node) => needsOf(node).filter(({ depthType }) => depthType === 'raw'));
  return readers.length + own.length > 0 && readers.every((port) => port.depthType === 'raw') ? { depthType: 'raw' } : {};
}

function needsOf(node: FlatNode): readonly Need[] {
  return (node.definition.needs ?? []).filter(
    ({ where, wired }) => (!where || structureValue(node, where.param) === where.is) && (!wired || node.inputs.has(wired)),
  );
}

/**
 * Whether the node outputs a layer that is not made from other layers. A scene always counts, even with an input for the layer that its
 * glass shows, because that is only a part of its output.
 */
function isOriginalLayer({ definition, inputs }: FlatNode): boolean {
  if (definition.lowering.kind === 'geometry') return Object.values(definition.outputs).some(({ type }) => type === 'layer');
  const makesLayer = Object.values(definition.outputs).some(({ type }) => type === 'layer');
  return makesLayer && !Object.entries(definition.inputs).some(([name, { type }]) => type === 'layer' && inputs.has(name));
}

function structureValue(node: FlatNode, name: string): ParamValue | undefined {
  const param = node.definition.params[name];
  return param && startValue(node, name, param);
}
