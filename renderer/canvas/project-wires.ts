import type { Edge } from '@xyflow/react';
import type { EncodingLookup } from '../../export/graph/encoding-lookup.ts';
import { inputOf } from '../../export/graph/library/node-interface.ts';
import type { Graph, GraphLayout, Project, Wire } from '../../export/graph/project.ts';
import { type Stretch, stretchesOf } from '../../export/graph/routes.ts';
import { printWire } from '../../export/graph/wires.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { portTitle } from '../state/document/message-titles.ts';
import { itemId } from '../state/editor/item-ids.ts';
import { nodeTitle } from '../state/editor/node-title.ts';

export interface WireData extends Record<string, unknown> {
  readonly from: WireType;
  readonly to: WireType;
  /** Position among the wires of the port, from 1; null if the port has one wire. */
  readonly order: number | null;
  /** Whether a node dropped now would be inserted into this wire. */
  readonly under: boolean;
  /** Whether the stretch is drawn as selected, because one of its wires is selected. */
  readonly lit: boolean;
  /** Whether the wire carries a scene layer. */
  readonly scene: boolean;
}

/** One drawn stretch: a whole wire, or the part of one or more wires between two reroutes. */
export type CanvasWire = Edge<WireData, 'scrim'>;

export interface WiresInput {
  readonly graph: Graph;
  readonly layout: GraphLayout;
  readonly library: NodeLibrary;
  readonly assets?: Project['assets'];
  readonly selectedWires: ReadonlySet<string>;
  /** The stretch that the dragged node would be inserted into. */
  readonly wireUnder?: string | null;
  /** Encodings of layers. If absent, all layers are display layers. */
  readonly encodings?: EncodingLookup;
}

interface CachedWire {
  readonly key: readonly unknown[];
  readonly wire: CanvasWire;
}

/**
 * Projects wires to edges of React Flow. Unchanged wires are the same objects as before, and the array is the same if none changed:
 * React Flow processes a new array wire by wire, which for 1,000 wires costs more than a drag of their nodes.
 */
export function createWiresProjection(): (input: WiresInput) => CanvasWire[] {
  let wires = new Map<string, CachedWire>();
  let list: CanvasWire[] = [];
  let seen: readonly unknown[] = [];
  return (input) => {
    const now = [input.graph, input.layout.routes, input.library, input.assets, input.selectedWires, input.wireUnder, input.encodings];
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
    const scene = input.encodings?.outputOf(wire.from) === 'scene';
    const label = stretch.to === null ? `${wireLabel(input, wire)}${scene ? ', scene layer' : ''}` : '';
    const lit = stretch.wires.some((one) => input.selectedWires.has(printWire(one)));
    const order = stretch.to === null ? (orders.get(id) ?? null) : null;
    const key = [from ?? to, to ?? from, order, lit, scene, label, input.wireUnder === id, ...endsOf(stretch)];
    const before = known.get(id);
    next.set(id, before && sameParts(before.key, key) ? before : { key, wire: canvasWire(id, stretch, key) });
  }
  return next;
}

/** Source, source handle, target and target handle. A reroute has one handle for incoming and one for outgoing wires. */
function endsOf({ source, wires, before, to }: Stretch): readonly [string, string, string, string] {
  const last = before.at(-1);
  const target = wires[0].to;
  return [
    ...(last === undefined ? ([source.node, source.port] as const) : ([itemId('reroute', last), REROUTE_OUT] as const)),
    ...(to === null ? ([target.node, target.port] as const) : ([itemId('reroute', to), REROUTE_IN] as const)),
  ];
}

/** Ids of the handles at which wires enter and leave a reroute. */
export const REROUTE_IN = 'in';
export const REROUTE_OUT = 'through';

function canvasWire(id: string, stretch: Stretch, key: readonly unknown[]): CanvasWire {
  const [from, to, order, lit, scene, ariaLabel, under, source, sourceHandle, target, targetHandle] = key as [
    WireType | undefined,
    WireType | undefined,
    number | null,
    boolean,
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
    // For keys and screen readers a wire is its last stretch alone; all of its stretches are drawn as selected.
    selected: isLast && lit,
    data: { from: from ?? 'number', to: to ?? 'number', order, under, lit, scene },
    ...(isLast ? { ariaLabel } : { focusable: false, domAttributes: { 'aria-hidden': true as const } }),
    // A wire is disconnected by dragging its end off a port; at a reroute, a drag moves the reroute.
    reconnectable: isFirst ? isLast || 'source' : isLast && 'target',
  };
}

function wireLabel({ graph, library, assets = {} }: WiresInput, { from, to }: Wire): string {
  const words = ({ node, port }: Wire['from']) => {
    const known = graph.nodes[node];
    const definition = known && library.definition(known.type);
    return definition ? portTitle(nodeTitle(known, library, assets), definition, port) : node;
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
