import type { Edge } from '@xyflow/react';
import type { Graph, Wire } from '../../export/graph/project.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { portWords } from '../state/plain-words.ts';

export interface WireData extends Record<string, unknown> {
  readonly from: WireType;
  readonly to: WireType;
  /** From 1, where the port takes several wires and has more than one. */
  readonly order: number | null;
  /** What is let go now goes into it. */
  readonly under: boolean;
}

export type CanvasWire = Edge<WireData, 'scrim'>;

export interface WiresInput {
  readonly graph: Graph;
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
    const now = [input.graph, input.library, input.selectedWires, input.wireUnder];
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
  const next = new Map<string, CachedWire>();
  for (const wire of input.graph.wires) {
    const id = wireId(wire);
    const place = (placed.get(portKey(wire.to)) ?? 0) + 1;
    placed.set(portKey(wire.to), place);
    const order = (count.get(portKey(wire.to)) ?? 0) > 1 ? place : null;
    const from = typeOf(wire.from.node, wire.from.port, 'output');
    const to = typeOf(wire.to.node, wire.to.port, 'input');
    const label = wireLabel(input, wire);
    const key = [from ?? to, to ?? from, order, input.selectedWires.has(id), label, input.wireUnder === id];
    const before = known.get(id);
    next.set(id, before && sameParts(before.key, key) ? before : { key, wire: canvasWire(wire, key) });
  }
  return next;
}

/** As the document writes it: unique, because two wires never join the same two ports. */
export function wireId({ from, to }: Wire): string {
  return `${from.node}.${from.port} -> ${to.node}.${to.port}`;
}

function canvasWire(wire: Wire, key: readonly unknown[]): CanvasWire {
  const [from, to, order, selected, ariaLabel, under] = key as [
    WireType | undefined,
    WireType | undefined,
    number | null,
    boolean,
    string,
    boolean,
  ];
  return {
    id: wireId(wire),
    type: 'scrim',
    source: wire.from.node,
    sourceHandle: wire.from.port,
    target: wire.to.node,
    targetHandle: wire.to.port,
    selected,
    data: { from: from ?? 'number', to: to ?? 'number', order, under },
    ariaLabel,
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
    if (side === 'output') return definition?.outputs[port]?.type;
    const param = definition?.params[port];
    return definition?.inputs[port]?.type ?? (param && paramType(param));
  };
}

function paramType(param: NodeDefinition['params'][string]): WireType | undefined {
  return param.type === 'choice' ? 'number' : param.type === 'asset' ? undefined : param.type;
}

function portKey({ node, port }: Wire['to']): string {
  return `${node}.${port}`;
}

export function sameParts(a: readonly unknown[], b: readonly unknown[]): boolean {
  return a.length === b.length && a.every((value, index) => value === b[index]);
}
