import type { Edge } from '@xyflow/react';
import { inputOf } from '../../export/graph/library/faces.ts';
import type { Graph, GraphLayout, Wire } from '../../export/graph/project.ts';
import { type Stretch, stretchesOf } from '../../export/graph/routes.ts';
import { printWire } from '../../export/graph/wires.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { itemId } from '../state/item-ids.ts';
import { portWords } from '../state/plain-words.ts';

export interface WireData extends Record<string, unknown> {
  readonly from: WireType;
  readonly to: WireType;
  /** From 1, where the port takes several wires and has more than one. */
  readonly order: number | null;
  /** What is let go now goes into it. */
  readonly under: boolean;
  /** Drawn as selected: one of the wires that it is a part of is. */
  readonly lit: boolean;
}

/** What is drawn of wires between two points: a whole wire, where that runs straight. */
export type CanvasWire = Edge<WireData, 'scrim'>;

export interface WiresInput {
  readonly graph: Graph;
  readonly layout: GraphLayout;
  readonly library: NodeLibrary;
  readonly selectedWires: ReadonlySet<string>;
  /** The wire that the dragged node would go into. */
  readonly wireUnder?: string | null;
}

interface CachedWire {
  readonly key: readonly unknown[];
  readonly wire: CanvasWire;
}

/**
 * Wires as React Flow draws them: those that did not change come out as the same objects, and as the same list where none did. React
 * Flow takes in a new list wire by wire, which for 1,000 of them would cost more than a drag of their nodes.
 */
export function createWiresProjection(): (input: WiresInput) => CanvasWire[] {
  let wires = new Map<string, CachedWire>();
  let list: CanvasWire[] = [];
  let seen: readonly unknown[] = [];
  return (input) => {
    const now = [input.graph, input.layout.routes, input.library, input.selectedWires, input.wireUnder];
    if (sameParts(now, seen)) return list;
    seen = now;
    wires = projectWires(input, wires);
    const next = [...wires.values()].map(({ wire }) => wire);
    if (!sameParts(next, list)) list = next;
    return list;
  };
}

function projectWires(input: WiresInput, known: ReadonlyMap<string, CachedWire>): Map<string, CachedWire> {
  const typeOf = portTypes(input);
  const count = new Map<string, number>();
  for (const wire of input.graph.wires) count.set(portKey(wire.to), (count.get(portKey(wire.to)) ?? 0) + 1);
  const placed = new Map<string, number>();
  const orders = new Map<string, number>();
  for (const wire of input.graph.wires) {
    const place = (placed.get(portKey(wire.to)) ?? 0) + 1;
    placed.set(portKey(wire.to), place);
    if ((count.get(portKey(wire.to)) ?? 0) > 1) orders.set(printWire(wire), place);
  }
  const next = new Map<string, CachedWire>();
  for (const [id, stretch] of stretchesOf(input.graph, input.layout)) {
    const [wire] = stretch.wires;
    const from = typeOf(wire.from.node, wire.from.port, 'output');
    const to = stretch.to === null ? typeOf(wire.to.node, wire.to.port, 'input') : from;
    const label = stretch.to === null ? wireLabel(input, wire) : '';
    const lit = stretch.wires.some((one) => input.selectedWires.has(printWire(one)));
    const order = stretch.to === null ? (orders.get(id) ?? null) : null;
    const key = [from ?? to, to ?? from, order, lit, label, input.wireUnder === id, ...endsOf(stretch)];
    const before = known.get(id);
    next.set(id, before && sameParts(before.key, key) ? before : { key, wire: canvasWire(id, stretch, key) });
  }
  return next;
}

/** What it joins, as React Flow knows it; reroutes have one side for wires that come and one for those that go. */
function endsOf({ source, wires, before, to }: Stretch): readonly [string, string, string, string] {
  const last = before.at(-1);
  const target = wires[0].to;
  return [
    ...(last === undefined ? ([source.node, source.port] as const) : ([itemId('reroute', last), REROUTE_OUT] as const)),
    ...(to === null ? ([target.node, target.port] as const) : ([itemId('reroute', to), REROUTE_IN] as const)),
  ];
}

/** The sides of a reroute. */
export const REROUTE_IN = 'in';
export const REROUTE_OUT = 'through';

function canvasWire(id: string, stretch: Stretch, key: readonly unknown[]): CanvasWire {
  const [from, to, order, lit, ariaLabel, under, source, sourceHandle, target, targetHandle] = key as [
    WireType | undefined,
    WireType | undefined,
    number | null,
    boolean,
    string,
    boolean,
    ...ReturnType<typeof endsOf>,
  ];
  const isLast = stretch.to === null;
  const isFirst = stretch.before.length === 0;
  return {
    id,
    type: 'scrim',
    source,
    sourceHandle,
    target,
    targetHandle,
    // A wire is one thing to React Flow's keys and to screen readers, its last stretch; all of it is drawn as selected.
    selected: isLast && lit,
    data: { from: from ?? 'number', to: to ?? 'number', order, under, lit },
    ...(isLast ? { ariaLabel } : { focusable: false, domAttributes: { 'aria-hidden': true as const } }),
    // Wires are pulled off ports; at a reroute, that is taken.
    reconnectable: isFirst ? isLast || 'source' : isLast && 'target',
  };
}

function wireLabel({ graph, library }: WiresInput, { from, to }: Wire): string {
  const words = ({ node, port }: Wire['from']) => {
    const definition = library.definition(graph.nodes[node]?.type ?? '');
    return definition ? portWords(definition, port) : node;
  };
  return `Wire from ${words(from)} to ${words(to)}`;
}

function portTypes({ graph, library }: WiresInput): (node: string, port: string, side: 'input' | 'output') => WireType | undefined {
  return (id, port, side) => {
    const definition = library.definition(graph.nodes[id]?.type ?? '');
    return side === 'output' ? definition?.outputs[port]?.type : definition && inputOf(definition, port)?.type;
  };
}

function portKey({ node, port }: Wire['to']): string {
  return `${node}.${port}`;
}

export function sameParts(a: readonly unknown[], b: readonly unknown[]): boolean {
  return a.length === b.length && a.every((value, index) => value === b[index]);
}
