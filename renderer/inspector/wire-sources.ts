import { canConnect } from '../../export/graph/connect.ts';
import type { Graph, PortAddress } from '../../export/graph/project.ts';
import { graphOf, type OpenGraph, titleOf } from '../state/document.ts';

/** An output, as lists call it. */
export interface WireSource {
  readonly from: PortAddress;
  readonly label: string;
}

/** All outputs that a port of the open graph would take. In a graph of 600 nodes it takes 20 ms: see `sameForWires`. */
export function sourcesFor(state: OpenGraph, to: PortAddress): readonly WireSource[] {
  return Object.entries(graphOf(state).nodes).flatMap(([id, { type }]) =>
    Object.entries(state.library.definition(type)?.outputs ?? {}).flatMap(([port, output]) => {
      const from = { node: id, port };
      const fits = canConnect(state.project, state.library, state.graph, from, to).ok;
      return fits ? [{ from, label: `${titleOf(state, id)} · ${output.label}` }] : [];
    }),
  );
}

/** Whether the same wires can be drawn in both: values alone are others, as while one is dragged. */
export function sameForWires(a: OpenGraph, b: OpenGraph): boolean {
  if (a.library !== b.library || a.graph !== b.graph) return false;
  const [before, after] = [graphOf(a), graphOf(b)];
  return before.wires === after.wires && before.exposed === after.exposed && sameKinds(before.nodes, after.nodes);
}

/** A muted node breaks no loop. */
function sameKinds(before: Graph['nodes'], after: Graph['nodes']): boolean {
  if (before === after) return true;
  const ids = Object.keys(after);
  return (
    ids.length === Object.keys(before).length &&
    ids.every((id) => {
      const [old, node] = [before[id], after[id]];
      return old === node || (old?.type === node?.type && old?.muted === node?.muted);
    })
  );
}
