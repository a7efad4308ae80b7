import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { canConnect, portsOfWire } from '../can-connect.ts';
import { createInterfaceLookup, takesSeveral } from '../library/node-interface.ts';
import { boundValue } from '../library/param-value.ts';
import type { PortAddress, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { insertWire, sameAddress, sameWire } from '../wires.ts';
import { type Change, change, draftGraph, graphOf, setWires, unchanged } from './change.ts';

export interface Connect {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly from: PortAddress;
  readonly to: PortAddress;
}

/**
 * Connects an output to an input. At a single-wire port the wire replaces the existing one; otherwise it becomes the port's last wire. A
 * connected param becomes a port.
 *
 * @returns The change, or a refusal with the reason of `canConnect`: the types do not convert, or a loop would close.
 * @throws Error if the graph does not exist.
 *
 * @example
 * connect(project, {
 *   library,
 *   graph: 'main',
 *   from: { node: 'video-a1b2', port: 'layer' },
 *   to: { node: 'sepia-k7q2', port: 'inputImage' },
 * });
 */
export function connect(project: Project, { library, graph: name, from, to }: Connect): Change {
  const possible = canConnect(project, library, name, from, to);
  if (!possible.ok) return { ...unchanged(project), diagnostics: [possible.reason] };
  const graph = graphOf(project, name);
  const interfaceOf = createInterfaceLookup(project, library);
  const ports = portsOfWire(graph, interfaceOf, { from, to });
  if (!ports.ok) throw new Error('The ports of a possible wire are missing.');
  const { input } = ports;
  const kept = takesSeveral(input) ? graph.wires : graph.wires.filter((wire) => !sameAddress(wire.to, to));
  return change(project, (draft) => {
    setWires(draft, name, insertWire(kept, { from, to }));
    if (input.kind !== 'param') return;
    const params = draftGraph(draft, name).nodes[to.node]?.params;
    const binding = getOwn(graph.nodes[to.node]?.params ?? {}, to.port);
    const value = (binding && boundValue(binding)) ?? input.param.default;
    if (params && !(binding && 'port' in binding)) params[to.port] = castDraft({ port: value });
  });
}

export interface Disconnect {
  readonly graph: string;
  readonly wires: readonly Wire[];
}

/**
 * Removes wires. A disconnected param stays a port, with the value that it had before.
 *
 * @returns The change; this command is never refused.
 * @throws Error if the graph does not exist.
 *
 * @example
 * disconnect(project, { graph: 'main', wires: [{ from, to }] });
 */
export function disconnect(project: Project, { graph, wires }: Disconnect): Change {
  const before = graphOf(project, graph).wires;
  const kept = before.filter((wire) => !wires.some((gone) => sameWire(gone, wire)));
  return kept.length === before.length ? unchanged(project) : change(project, (draft) => setWires(draft, graph, kept));
}

export interface ReorderWires {
  readonly graph: string;
  readonly to: PortAddress;
  /** The sources of the port's wires in their new order. */
  readonly from: readonly PortAddress[];
}

/**
 * Changes the order of the wires at one port.
 *
 * @returns The change; this command is never refused.
 * @throws Error if the graph does not exist.
 *
 * @example
 * reorderWires(project, { graph: 'main', to: { node: 'over-p3m9', port: 'layers' }, from: [second, first] });
 */
export function reorderWires(project: Project, { graph, to, from }: ReorderWires): Change {
  const { wires } = graphOf(project, graph);
  const here = wires.filter((wire) => sameAddress(wire.to, to));
  const place = (wire: Wire) => {
    const index = from.findIndex((source) => sameAddress(source, wire.from));
    return index === -1 ? from.length : index;
  };
  const ordered = [...here].sort((a, b) => place(a) - place(b));
  let next = 0;
  const replaced = wires.map((wire) => (sameAddress(wire.to, to) ? (ordered[next++] ?? wire) : wire));
  return replaced.every((wire, i) => wire === wires[i]) ? unchanged(project) : change(project, (draft) => setWires(draft, graph, replaced));
}
